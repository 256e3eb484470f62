#include <solitaire/search.h>

#include "library/search_state.h"

namespace solitaire::api {

SearchObserver::~SearchObserver() = default;
void SearchObserver::explored(std::size_t) {}
void SearchObserver::improved(const Solution&) {}

Search::Search(const Program& program, const SearchOptions& options)
    : state_(std::make_unique<State>(program, options)) {}
Search::~Search() = default;

std::optional<Solution> Search::next() { return state_->next(); }
Ending Search::ending() const { return state_->ending(); }
StopToken Search::stop_token() const { return state_->stop_token(); }
void Search::observe(SearchObserver* observer) { state_->observe(observer); }
std::vector<Solution> Search::resume(const std::vector<std::vector<Choice>>& earlier) {
  return state_->resume(earlier);
}
Summary Search::summary() const { return state_->summary(); }
std::optional<Solution> Search::take_best_so_far() { return state_->take_best_so_far(); }
void Search::write_formula(const std::filesystem::path& path) { state_->write_formula(path); }

}  // namespace solitaire::api
