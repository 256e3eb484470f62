#pragma once
#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace solitaire {

/// Says where in an execution something happened: the chain of call sites and loop turns that led there, and
/// its own site. It is the same in every run that comes there (the addressing scheme of section 4.3.1). The
/// id is an index into an AddressTable, in which equal ids are equal addresses.
struct AddressId {
  std::uint32_t index = 0;
  friend auto operator<=>(AddressId, AddressId) = default;
};

/// Interns addresses. Each is its parent and one step more: a site's label, or a loop turn counted from 0.
class AddressTable {
 public:
  AddressTable();

  /// A site's label in this table.
  using LabelId = std::uint32_t;
  static constexpr LabelId kNoLabel = UINT32_MAX;

  static constexpr AddressId root() { return {0}; }
  LabelId label(std::string_view text);
  AddressId site(AddressId parent, LabelId label) { return intern({parent.index, label, 0}); }
  AddressId site(AddressId parent, std::string_view label) { return site(parent, this->label(label)); }
  AddressId turn(AddressId parent, std::uint32_t number) { return intern({parent.index, kTurn, number}); }

  /// The address with that readable form.
  AddressId address(std::string_view text);

  /// The readable form: "wing[2]/room[0]/make_table/rot". Empty for the root.
  const std::string& text(AddressId address) const;
  /// The readable steps, each with its turns: "wing[2]", "room[0]", "make_table", "rot".
  std::vector<std::string> steps(AddressId address) const;

  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::uint32_t parent;
    std::uint32_t label;  // index into labels_, or kTurn
    std::uint32_t turn;
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  static constexpr std::uint32_t kTurn = UINT32_MAX - 1;

  AddressId intern(const Entry& entry) {
    for (std::size_t at = hash(entry) & mask_;; at = (at + 1) & mask_) {
      const std::uint32_t number = slots_[at];
      if (number == kFree) return add(entry, at);
      if (entries_[number] == entry) return {number};
    }
  }
  static std::size_t hash(const Entry& entry);
  AddressId add(const Entry& entry, std::size_t at);

  static constexpr std::uint32_t kFree = UINT32_MAX;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;  // open addressing: numbers of entries, at most half of them taken
  std::size_t mask_;
  mutable std::unordered_map<std::uint32_t, std::string> texts_;  // the texts that somebody asked for
  std::vector<std::string> labels_;
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> label_ids_;
};

}  // namespace solitaire

template <>
struct std::hash<solitaire::AddressId> {
  std::size_t operator()(solitaire::AddressId id) const noexcept { return id.index; }
};
