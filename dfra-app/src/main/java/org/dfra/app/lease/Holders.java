package org.dfra.app.lease;

import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.app.team.Administration;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/** Which modules hold which leases: each is asked for those that are held in its process. */
final class Holders {

  private final Map<UUID, Set<String>> modules = new HashMap<>();

  /** One module's answer has come. */
  Holders add(String module, Set<UUID> leases) {
    leases.forEach(each -> modules.computeIfAbsent(each, key -> new TreeSet<>()).add(module));
    return this;
  }

  /** The modules of the process that holds a lease; none where no module is known to hold it. */
  List<String> of(UUID lease) {
    return List.copyOf(modules.getOrDefault(lease, Set.of()));
  }

  /**
   * Asks all modules of a list at once. One that does not answer, or does not know the question
   * since it is of an older version, is left out.
   *
   * @param deadline how long the answers are awaited, all together
   */
  static Holders among(List<ModuleListing<Module>> all, Duration deadline)
      throws InterruptedException {
    ExecutorService askers =
        Executors.newCachedThreadPool(
            task -> {
              Thread thread = new Thread(task, "dfra-asks-holders");
              thread.setDaemon(true);
              return thread;
            });
    try {
      Map<String, Future<Set<UUID>>> asked = new LinkedHashMap<>();
      for (ModuleListing<Module> each : all) {
        if (!each.stale()) {
          asked.put(each.path(), askers.submit(() -> Administration.of(each).heldLeases()));
        }
      }
      long end = System.nanoTime() + deadline.toNanos();
      Holders holders = new Holders();
      for (Map.Entry<String, Future<Set<UUID>>> each : asked.entrySet()) {
        @Nullable Set<UUID> held = answer(each.getValue(), end - System.nanoTime());
        if (held != null) {
          holders.add(each.getKey(), held);
        }
      }
      return holders;
    } finally {
      askers.shutdownNow();
    }
  }

  private static @Nullable Set<UUID> answer(Future<Set<UUID>> asked, long nanos)
      throws InterruptedException {
    try {
      return asked.get(Math.max(0, nanos), TimeUnit.NANOSECONDS);
    } catch (ExecutionException | TimeoutException e) {
      asked.cancel(true);
      return null; // the address of its leases' holder is told instead
    }
  }
}
