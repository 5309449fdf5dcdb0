package org.dfra.cli.module;

import java.time.Duration;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.cli.team.UnreadyModule;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code ./dfra module list}. */
@Command(name = "list", description = "Lists the modules of the team.")
final class ModuleListCommand implements Callable<Integer> {

  /** Timeout for modules that are not ready to report the reason. */
  private static final Duration WHY = Duration.ofSeconds(2);

  @Option(names = "--robot", paramLabel = "ROBOT", description = "Only those of this robot.")
  private @Nullable String robot;

  @Option(
      names = "--kind",
      paramLabel = "KIND",
      description = "Only those of this kind, e.g. GPSSensor.")
  private @Nullable String kind;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = options.open()) {
      ModuleQuery<Module> any = ModuleQuery.of(Module.class);
      JiniModuleDirectory directory = team.awaitDirectory();
      List<ModuleListing<Module>> listings =
          directory.find(robot == null ? any : any.robot(robot)).stream()
              .filter(each -> kind == null || ModuleKinds.hasKind(each.module(), kind))
              .toList();
      Map<UUID, String> reasons = new HashMap<>();
      UnreadyModule.query(listings, WHY).forEach(each -> reasons.put(each.id(), each.reason()));
      List<ModuleView> modules =
          Stream.concat(
                  listings.stream().map(each -> view(each, reasons.get(each.id()))),
                  refused(directory))
              .sorted(Comparator.comparing(ModuleView::path).thenComparing(ModuleView::host))
              .toList();
      ModuleListPrinter.show(options.answer(), modules, nothing());
      team.noteDuplicateNames();
      team.noteConflicts();
      return ExitCode.SUCCESS;
    }
  }

  private static ModuleView view(ModuleListing<Module> listing, @Nullable String reason) {
    ModuleView view = ModuleView.of(listing);
    return reason == null ? view : view.withReason(reason);
  }

  /** Those whose proxies cannot be deserialized here; their kinds are unknown. */
  private Stream<ModuleView> refused(JiniModuleDirectory directory) {
    return kind != null
        ? Stream.of()
        : directory.unreadableModules().stream()
            .filter(each -> robot == null || each.robot().equals(robot))
            .map(ModuleView::of);
  }

  private String nothing() {
    return "No module"
        + (robot == null ? "" : " of robot " + robot)
        + (kind == null ? "" : " of kind " + kind)
        + " is registered.";
  }
}
