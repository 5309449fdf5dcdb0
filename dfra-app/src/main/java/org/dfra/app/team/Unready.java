package org.dfra.app.team;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A module that does not serve, and why.
 *
 * @param id its service ID
 * @param path {@code robot/name}
 * @param state its state as the lookup services know it
 * @param reason why, as the rest of a sentence
 */
public record Unready(UUID id, String path, Readiness state, String reason) {

  /**
   * Asks all modules of a list that do not serve why, at once; stale ones are left out.
   *
   * @param deadline how long the answers are awaited, all together
   */
  public static List<Unready> among(List<? extends ModuleListing<?>> modules, Duration deadline)
      throws InterruptedException {
    ExecutorService askers =
        Executors.newCachedThreadPool(
            task -> {
              Thread thread = new Thread(task, "dfra-asks-why");
              thread.setDaemon(true);
              return thread;
            });
    try {
      Map<ModuleListing<?>, Future<@Nullable String>> asked = new LinkedHashMap<>();
      for (ModuleListing<?> each : modules) {
        Optional<Readiness> state = state(each);
        if (!each.stale() && state.isPresent() && !state.get().serves()) {
          asked.put(each, askers.submit(() -> reason(each)));
        }
      }
      long end = System.nanoTime() + deadline.toNanos();
      List<Unready> all = new ArrayList<>();
      for (Map.Entry<ModuleListing<?>, Future<@Nullable String>> each : asked.entrySet()) {
        ModuleListing<?> module = each.getKey();
        @Nullable String reason = answer(each.getValue(), end - System.nanoTime());
        if (reason != null) { // else it has come to serve meanwhile
          all.add(new Unready(module.id(), module.path(), state(module).orElseThrow(), reason));
        }
      }
      return all;
    } finally {
      askers.shutdownNow();
    }
  }

  private static Optional<Readiness> state(ModuleListing<?> module) {
    return module.attributes(ModuleAttributes.class).map(ModuleAttributes::state);
  }

  private static @Nullable String reason(ModuleListing<?> module) throws RemoteException {
    return Administration.of(module).unreadiness();
  }

  private static @Nullable String answer(Future<@Nullable String> asked, long nanos)
      throws InterruptedException {
    try {
      return asked.get(Math.max(0, nanos), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      asked.cancel(true);
      return "it does not answer why; see whether its process hangs";
    } catch (ExecutionException e) {
      return "it does not say why (" + root(e) + ")";
    }
  }

  /** In one line; one of an older version, say, does not know the question. */
  private static String root(Throwable failure) {
    Throwable root = failure;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    return root.toString().lines().findFirst().orElse("");
  }
}
