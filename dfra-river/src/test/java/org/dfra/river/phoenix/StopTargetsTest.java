package org.dfra.river.phoenix;

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
import org.dfra.flow.effector.StopState;
import org.dfra.river.phoenix.stop.EffectorStop;
import org.dfra.river.phoenix.stop.GroupStopAnswer;
import org.dfra.river.phoenix.stop.StopTarget;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StopTargetsTest {

  /** An effector's server, as far as it is stopped. */
  private static class Target implements Remote, StopTarget {
    private final String path;
    private StopState now = StopState.NEVER; // guarded by this

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
    public synchronized StopState stopState() {
      return now;
    }

    @Override
    public synchronized StopState emergencyStop(@Nullable String by) throws RemoteException {
      now = new StopState(true, by, Instant.EPOCH, true, null);
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

  private StopTargets targets(Duration patience) {
    return new StopTargets(patience, threads);
  }

  private static void add(StopTargets targets, ActivationID id, Remote object) {
    targets.made(id, object, targets.orders());
  }

  @Test
  void stopsEffectorsAndNamesWhatIsNone() {
    StopTargets targets = targets(Duration.ofSeconds(30));
    Target drive = new Target("eta/drive");
    add(targets, id(), drive);
    add(targets, id(), new Remote() {});
    GroupStopAnswer answer = targets.emergencyStop("ops");
    assertThat(answer.effectors())
        .singleElement()
        .satisfies(
            each -> {
              assertThat(each.object()).isEqualTo(ids.get(0));
              assertThat(each.stop().isConfirmed()).isTrue();
              assertThat(each.stop().wasStopped()).isFalse();
            });
    assertThat(answer.others()).containsExactly(ids.get(1));
    assertThat(drive.stopState().by()).isEqualTo("ops");
    assertThat(targets.emergencyStop("ops").effectors().get(0).stop().wasStopped()).isTrue();
    targets.inactive(ids.get(0));
    assertThat(targets.emergencyStop("ops").effectors()).isEmpty();
  }

  @Test
  void oneThatDoesNotAnswerOrFailsDelaysNoOther() throws Exception {
    StopTargets targets = targets(Duration.ofMillis(300));
    add(
        targets,
        id(),
        new Target("eta/mute") {
          @Override
          public StopState emergencyStop(@Nullable String by) throws RemoteException {
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
          public StopState emergencyStop(@Nullable String by) {
            throw new IllegalStateException("a driver's fault");
          }
        });
    CountDownLatch reached = new CountDownLatch(1);
    add(
        targets,
        id(),
        new Target("eta/drive") {
          @Override
          public StopState emergencyStop(@Nullable String by) throws RemoteException {
            reached.countDown();
            return super.emergencyStop(by);
          }
        });
    List<EffectorStop> stops =
        targets.emergencyStop("ops").effectors().stream()
            .map(GroupStopAnswer.Stopped::stop)
            .toList();
    assertThat(reached.await(30, TimeUnit.SECONDS)).as("ordered beside the first").isTrue();
    assertThat(stops).hasSize(3);
    assertThat(stops)
        .filteredOn(each -> each.path().equals("eta/mute"))
        .singleElement()
        .returns("it did not answer within 0.3 s", EffectorStop::fault);
    assertThat(stops)
        .filteredOn(each -> each.path().equals("eta/broken"))
        .singleElement()
        .satisfies(each -> assertThat(each.fault()).contains("a driver's fault"));
  }

  @Test
  void oneThatCannotSayWhetherItWasStoppedIsStopped() {
    StopTargets targets = targets(Duration.ofSeconds(30));
    add(
        targets,
        id(),
        new Target("eta/drive") {
          @Override
          public synchronized StopState stopState() {
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
    StopTargets targets = targets(Duration.ofSeconds(30));
    long before = targets.orders();
    GroupStopAnswer unused = targets.emergencyStop("ops");
    Target drive = new Target("eta/drive");
    targets.made(id(), drive, before);
    assertThat(drive.stopState().latched()).isTrue();
    Target later = new Target("eta/head");
    add(targets, id(), later);
    assertThat(later.stopState().latched()).as("its making began after the order").isFalse();
  }
}
