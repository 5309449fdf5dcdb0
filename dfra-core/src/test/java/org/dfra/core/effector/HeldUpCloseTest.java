package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A driver that is held up by a command is closed all the same. */
@Timeout(60)
class HeldUpCloseTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final List<String> steps = new CopyOnWriteArrayList<>();
  private final CountDownLatch heldUp = new CountDownLatch(1);
  private final CountDownLatch release = new CountDownLatch(1);
  private final Stuck drive = new Stuck();

  private final class Stuck extends DriveImpl {

    Stuck() {
      super(
          new ModuleContext(
              "atrv1",
              "drive",
              Parameters.of("atrv1/drive", Map.of()),
              InstantSource.system(),
              StateStore.inMemory()),
          "a drive whose line is stuck",
          "DFRA",
          "1",
          new DriveAttributes(1, 2, 1, 1),
          0,
          List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      steps.add("closed");
    }

    @Override
    protected void setVelocity(Velocity wanted) {
      heldUp.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      steps.add("turned");
    }

    @Override
    protected void halt() {
      steps.add("halt");
    }

    @Override
    protected void brake(boolean set) {}
  }

  @AfterEach
  void release() {
    release.countDown();
  }

  @Test
  void aDriverThatIsHeldUpByACommandIsHaltedAndClosed() throws Exception {
    drive.start();
    CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(10));
    Thread commander =
        new Thread(() -> drive.execute(lease.key(), new Velocity(0.5, 0)), "commander");
    commander.start();
    heldUp.await();

    Thread closing = new Thread(drive::close, "closing");
    closing.start();

    await("while the command is still held up")
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(steps).containsExactly("halt", "closed"));
    release.countDown();
    commander.join();
    closing.join();
    await("the lease has ended").atMost(PATIENCE).until(() -> drive.leases().leases().isEmpty());
    await("it comes to rest")
        .atMost(PATIENCE)
        .until(() -> steps.lastIndexOf("halt") > steps.indexOf("turned"));
  }
}
