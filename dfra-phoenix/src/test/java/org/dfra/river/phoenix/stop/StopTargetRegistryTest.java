package org.dfra.river.phoenix.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.phoenix.stop.StopTargetRegistry.StopTarget;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StopTargetRegistryTest {

  /** An effector's server, as far as it is stopped. */
  private static class Target implements Remote, StopTarget {
    private final String path;
    private EmergencyStopState now = EmergencyStopState.NEVER; // guarded by this

    Target(String path) {
      this.path = path;
    }

    @Override
    public UUID moduleId() {
      return UUID.nameUUIDFromBytes(path.getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public String modulePath() {
      return path;
    }

    @Override
    public synchronized EmergencyStopState emergencyStopState() {
      return now;
    }

    @Override
    public synchronized EmergencyStopState emergencyStop(@Nullable String by)
        throws RemoteException {
      now = new EmergencyStopState(true, by, Instant.EPOCH, true, null);
      return now;
    }
  }

  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final CountDownLatch end = new CountDownLatch(1);
  private final List<ActivationID> ids = new ArrayList<>();

  @AfterEach
  void end() {
    end.countDown();
    threads.shutdownNow();
  }

  private ActivationID id() {
    ActivationID id = new ActivationID(null);
    ids.add(id);
    return id;
  }

  private StopTargetRegistry targets(Duration patience) {
    return new StopTargetRegistry(patience, threads);
  }

  private static void add(StopTargetRegistry targets, ActivationID id, Remote object) {
    targets.made(id, object, targets.requestCount());
  }

  @Test
  void stopsEffectorsAndNamesWhatIsNone() {
    StopTargetRegistry targets = targets(Duration.ofSeconds(30));
    Target drive = new Target("eta/drive");
    add(targets, id(), drive);
    add(targets, id(), new Remote() {});
    GroupStopResult answer = targets.emergencyStop("ops");
    assertThat(answer.effectors())
        .singleElement()
        .satisfies(
            each -> {
              assertThat(each.object()).isEqualTo(ids.get(0));
              assertThat(each.stop().isConfirmed()).isTrue();
              assertThat(each.stop().wasStopped()).isFalse();
            });
    assertThat(answer.otherObjects()).containsExactly(ids.get(1));
    assertThat(drive.emergencyStopState().requester()).isEqualTo("ops");
    assertThat(targets.emergencyStop("ops").effectors().get(0).stop().wasStopped()).isTrue();
    targets.inactive(ids.get(0));
    assertThat(targets.emergencyStop("ops").effectors()).isEmpty();
  }

  @Test
  void oneThatDoesNotAnswerOrFailsDelaysNoOther() throws Exception {
    StopTargetRegistry targets = targets(Duration.ofMillis(300));
    add(
        targets,
        id(),
        new Target("eta/mute") {
          @Override
          public EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException {
            try {
              end.await();
            } catch (InterruptedException e) {
              throw new RemoteException("interrupted", e);
            }
            return super.emergencyStop(by);
          }
        });
    add(
        targets,
        id(),
        new Target("eta/broken") {
          @Override
          public EmergencyStopState emergencyStop(@Nullable String by) {
            throw new IllegalStateException("a driver's fault");
          }
        });
    CountDownLatch reached = new CountDownLatch(1);
    add(
        targets,
        id(),
        new Target("eta/drive") {
          @Override
          public EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException {
            reached.countDown();
            return super.emergencyStop(by);
          }
        });
    List<EffectorStopResult> stops =
        targets.emergencyStop("ops").effectors().stream()
            .map(GroupStopResult.EffectorAnswer::stop)
            .toList();
    assertThat(reached.await(30, TimeUnit.SECONDS)).as("ordered beside the first").isTrue();
    assertThat(stops).hasSize(3);
    assertThat(stops)
        .filteredOn(each -> each.path().equals("eta/mute"))
        .singleElement()
        .returns("it did not answer within 0.3 s", EffectorStopResult::fault);
    assertThat(stops)
        .filteredOn(each -> each.path().equals("eta/broken"))
        .singleElement()
        .satisfies(each -> assertThat(each.fault()).contains("a driver's fault"));
  }

  @Test
  void oneThatCannotSayWhetherItWasStoppedIsStopped() {
    StopTargetRegistry targets = targets(Duration.ofSeconds(30));
    add(
        targets,
        id(),
        new Target("eta/drive") {
          @Override
          public synchronized EmergencyStopState emergencyStopState() {
            throw new IllegalStateException("a driver's fault");
          }
        });
    assertThat(targets.emergencyStop("ops").effectors())
        .singleElement()
        .satisfies(
            each -> {
              assertThat(each.stop().isConfirmed()).isTrue();
              assertThat(each.stop().wasStopped()).isFalse();
            });
  }

  @Test
  void whatWasBeingMadeDuringAnOrderIsStopped() {
    StopTargetRegistry targets = targets(Duration.ofSeconds(30));
    long before = targets.requestCount();
    GroupStopResult unused = targets.emergencyStop("ops");
    Target drive = new Target("eta/drive");
    targets.made(id(), drive, before);
    assertThat(drive.emergencyStopState().latched()).isTrue();
    Target later = new Target("eta/head");
    add(targets, id(), later);
    assertThat(later.emergencyStopState().latched())
        .as("its making began after the order")
        .isFalse();
  }
}
