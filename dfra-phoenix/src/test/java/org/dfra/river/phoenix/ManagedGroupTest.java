package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jini.config.ConfigurationFile;
import org.dfra.river.phoenix.ManagedGroup.ActiveInstantiator;
import org.dfra.river.phoenix.restart.CrashHistory;
import org.dfra.river.phoenix.restart.CrashHistory.ProcessExit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What a group answers while its lock is held, as it is while the journal is written. */
@Timeout(60)
class ManagedGroupTest {

  private static final ProcessIdentity PROCESS = new ProcessIdentity(4711, "tick 1 of boot x");

  @TempDir Path temp;
  private final CountDownLatch isHeld = new CountDownLatch(1);
  private final CountDownLatch release = new CountDownLatch(1);

  /** Is called under the lock. */
  private final class HoldingRestarts implements ManagedGroup.Restarts {
    @Override
    public boolean wasStable(ManagedGroup group, long incarnation) {
      isHeld.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      return true;
    }

    @Override
    public void schedule(ManagedGroup group, Duration delay) {
      assertThat(delay).isGreaterThanOrEqualTo(Duration.ZERO);
    }
  }

  @Test
  void anEmergencyStopFindsTheProcessWhileTheLockIsHeld() throws Exception {
    PhoenixConfiguration configuration =
        PhoenixConfiguration.read(
            new ConfigurationFile(
                new StringReader(
                    "org.dfra.river.phoenix { persistenceDirectory = \""
                        + temp.resolve("journal")
                        + "\"; }"),
                new String[0]),
            SecretIdentities.fresh());
    DaemonState state = new DaemonState();
    DaemonExecutors threads = new DaemonExecutors();
    ProcessWatcher watcher =
        new ProcessWatcher(threads, configuration.groupTimeout(), configuration.unexportTimeout());
    try (Journal journal = Journal.open(configuration.persistenceDirectory(), 1000);
        FakeGroup fake = new FakeGroup()) {
      ManagedGroup group =
          new ManagedGroup(
              new ActivationGroupID(null),
              "1-eta.wheels",
              GroupIncarnation.past(7),
              new GroupSupervisor(
                  "1-eta.wheels",
                  configuration,
                  InstantSource.system(),
                  state,
                  new CrashHistory(configuration.restartPolicy(), System::nanoTime)),
              configuration.groupTimeout(),
              journal,
              state,
              watcher,
              new GroupLauncher(configuration, journal, state, watcher),
              new HoldingRestarts());
      group.adopt(PROCESS, fake.proxy, false, Set.of());
      CompletableFuture<Void> holder =
          CompletableFuture.runAsync(
              () -> group.onProcessExit(PROCESS, ProcessExit.unrequested("was killed")));
      isHeld.await();
      try {
        assertThat(CompletableFuture.supplyAsync(group::active).get(10, TimeUnit.SECONDS))
            .contains(new ActiveInstantiator(fake.proxy, 7));
      } finally {
        release.countDown();
      }
      holder.get(10, TimeUnit.SECONDS);
      assertThat(group.active()).as("after its exit").isEmpty();
    } finally {
      threads.stop();
    }
  }
}
