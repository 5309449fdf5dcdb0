package org.dfra.cli.team;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.TimeoutException;
import org.dfra.directory.ModuleListing;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;

/**
 * A module that is not ready, with the reason.
 *
 * @param id its service ID
 * @param path {@code robot/name}
 * @param state its state in the lookup services
 * @param reason as the rest of a sentence
 */
public record UnreadyModule(UUID id, String path, Readiness state, String reason) {

  /**
   * Queries all modules of a list that are not ready for the reason, in parallel; omits stale ones.
   *
   * @param deadline timeout for all answers together
   */
  public static List<UnreadyModule> query(
      List<? extends ModuleListing<?>> modules, Duration deadline) throws InterruptedException {
    List<ModuleListing<?>> asked = new ArrayList<>();
    for (ModuleListing<?> each : modules) {
      Optional<Readiness> state = state(each);
      if (!each.stale() && state.isPresent() && !state.get().serves()) {
        asked.add(each);
      }
    }
    List<Optional<String>> reasons =
        ParallelQuery.ask(
            asked,
            each -> () -> Optional.ofNullable(Administration.of(each).unreadiness()),
            cause -> Optional.of(unanswered(cause)),
            deadline);
    List<UnreadyModule> all = new ArrayList<>();
    for (int i = 0; i < asked.size(); i++) {
      ModuleListing<?> module = asked.get(i);
      // Otherwise it has become ready meanwhile.
      reasons
          .get(i)
          .ifPresent(
              reason ->
                  all.add(
                      new UnreadyModule(
                          module.id(), module.path(), state(module).orElseThrow(), reason)));
    }
    return all;
  }

  private static Optional<Readiness> state(ModuleListing<?> module) {
    return module.attributes(ModuleAttributes.class).map(ModuleAttributes::state);
  }

  private static String unanswered(Throwable cause) {
    return cause instanceof TimeoutException
        ? "it does not answer why; see whether its process hangs"
        : "it does not say why (" + root(cause) + ")";
  }

  /** In one line; for example, a module of an older version does not support the query. */
  private static String root(Throwable failure) {
    Throwable root = failure;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    return root.toString().lines().findFirst().orElse("");
  }
}
