#include "obrys/workspace.hpp"

#include "base/number.hpp"
#include "base/text.hpp"
#include "obrys/shown.hpp"
#include "obrys/version.hpp"

namespace obrys::api {

const char* version() { return OBRYS_VERSION; }

std::vector<std::string> controls() { return driver::controls(); }

Image::Image(std::shared_ptr<const driver::Image> of) : image_(std::move(of)) {}

bool Image::usable() const { return image_->usable(); }
std::vector<Message> Image::messages() const { return shown(image_->session()); }
std::string Image::control() const { return image_->session().control; }
std::string Image::program() const { return image_->session().program; }

Workspace::Workspace(std::shared_ptr<driver::Memory> memory) : memory_(std::move(memory)) {}

Workspace Workspace::in_memory() { return Workspace(std::make_shared<driver::Memory>()); }
Workspace Workspace::over_disk() { return Workspace(std::make_shared<driver::Memory>(driver::disk())); }

void Workspace::put(const std::string& path, std::string bytes) { memory_->put(path, std::move(bytes)); }
bool Workspace::remove(const std::string& path) { return memory_->remove(path); }

Image Workspace::prepare(const std::string& input, const Options& options) const {
    driver::Request request;
    request.input = input;
    request.control = options.control;
    request.machine = options.machine;
    request.search = options.search;
    request.tools = options.tools;
    for (const auto& [name, value] : options.set) request.set.push_back(name + "=" + base::shortest(value));
    request.skip = options.skip;
    request.folders = std::make_shared<driver::Folders>(memory_->snapshot());
    driver::MillingRequest milling;
    milling.tolerance = options.tolerance;
    return Image(driver::Image::prepare(request, milling));
}

}  // namespace obrys::api
