package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.StringReader;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.config.ConfigurationFile;
import org.dfra.river.phoenix.restart.CrashHistory.ProcessExit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** How a group's process is started, and ended if the group refuses it. */
@Timeout(120)
class GroupLauncherTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @TempDir Path temp;
  private final ActivationGroupID group = new ActivationGroupID(null);
  private final DaemonState state = new DaemonState();
  private final DaemonExecutors threads = new DaemonExecutors();
  private Journal journal;
  private GroupLauncher launcher;

  @BeforeEach
  void open() throws Exception {
    PhoenixConfiguration configuration =
        PhoenixConfiguration.read(
            new ConfigurationFile(
                new StringReader(
                    "org.dfra.river.phoenix { groupThrottle = 1; persistenceDirectory = \""
                        + temp.resolve("journal")
                        + "\"; }"),
                new String[0]),
            SecretIdentities.fresh());
    journal = Journal.open(configuration.persistenceDirectory(), 1000);
    journal.commit(
        new JournalRecord.GroupRegistered(
            group,
            "1-group",
            new ActivationGroupDesc(
                null,
                new ActivationGroupDesc.CommandEnvironment(
                    new InVmPhoenix(temp).idleCommand(), new String[0]))));
    ProcessWatcher watcher =
        new ProcessWatcher(threads, configuration.groupTimeout(), configuration.unexportTimeout());
    launcher = new GroupLauncher(configuration, journal, state, watcher);
  }

  @AfterEach
  void close() throws Exception {
    threads.stop();
    journal.close();
  }

  /** A group; it refuses its process if there is a refusal. */
  private static final class Owner implements GroupLauncher.LaunchOwner {
    private final BlockingQueue<ProcessIdentity> launched = new LinkedBlockingQueue<>();
    private final BlockingQueue<ProcessIdentity> exited = new LinkedBlockingQueue<>();
    private volatile @Nullable ActivationException refusal;

    @Override
    public void launched(long incarnation, ProcessIdentity started) throws ActivationException {
      launched.add(started);
      @Nullable ActivationException thrown = refusal;
      if (thrown != null) {
        throw thrown;
      }
    }

    @Override
    public void onProcessExit(ProcessIdentity who, ProcessExit exit) {
      exited.add(who);
    }

    @Override
    public void killUnlessReported(ProcessIdentity who) {
      who.kill();
    }
  }

  @Test
  void aProcessThatItsGroupRefusesIsKilledAndKeepsNoPermit() throws Exception {
    Owner owner = new Owner();
    ActivationException refusal = new ActivationException("not awaited any more");
    owner.refusal = refusal;
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> launcher.launch(group, "1-group", 1, owner))
        .isSameAs(refusal);
    assertThat(owner.launched.remove().awaitExit(PATIENCE)).as("it exits").isTrue();

    owner.refusal = null;
    launcher.launch(group, "1-group", 2, owner); // with the only permit
    ProcessIdentity second = owner.launched.remove();
    assertThat(second.isAlive()).isTrue();
    assertThat(journal.<ProcessIdentity>read(r -> r.group(group).process)).isEqualTo(second);
    second.kill();
    assertThat(owner.exited.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isEqualTo(second);
  }

  @Test
  void nothingIsStartedWhilePhoenixShutsDown() {
    Owner owner = new Owner();
    state.setEnding();
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> launcher.launch(group, "1-group", 1, owner))
        .withMessageContaining("phoenix is shutting down");
    assertThat(owner.launched).isEmpty();
    assertThat(journal.<Long>read(r -> r.group(group).incarnation)).as("recorded").isZero();
  }
}
