#pragma once

#include <memory>
#include <optional>

#include "game/program/session.h"

namespace oblong {

/// The picture behind the title's menu: the recorded walk through the demo level until it has found all lenses, in a
/// loop; without a record for this level, its start.
class Title final : public GameScreen {
  public:
    /// `demo_file`: the record, which may be missing. Throws FileError if it is damaged. `view_options` and `platform`
    /// outlive the title.
    Title(std::shared_ptr<const LoadedLevel> loaded, const std::string& demo_file, Workers* workers,
          ViewOptions& view_options, Platform& platform);

    void advance(const Controls& controls, std::uint64_t now_us) override { walk_->advance(controls, now_us); }
    void advance_behind_menu(std::uint64_t now_us) override;
    bool moves_behind_menu() const override { return walk_->input().is_replaying(); }
    bool is_heard(bool) const override { return true; }
    ShownPicture draw(bool is_behind_menu) override { return walk_->draw(is_behind_menu); }
    const MenuLook& menu_look() const override { return walk_->menu_look(); }
    void open_page(Action, MenuPages&) override {}
    void open_due_page(MenuPages& pages) override { pages.open_title(); }
    const std::shared_ptr<const LoadedLevel>& shared_level() const override { return walk_->shared_level(); }
    std::vector<KeyHelp> key_help(const KeyNames& names) const override { return walk_->key_help(names); }

  private:
    void begin();

    const std::shared_ptr<const LoadedLevel> loaded_;
    const SessionSettings settings_;
    ViewOptions& view_options_;
    Platform& platform_;
    std::optional<Demo> demo_;
    std::unique_ptr<Session> walk_;
};

}  // namespace oblong
