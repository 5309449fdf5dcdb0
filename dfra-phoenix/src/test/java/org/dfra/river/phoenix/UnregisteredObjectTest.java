package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.UnknownObjectException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.Test;

/** An object that is unregistered while it is active is remembered until its process ends. */
class UnregisteredObjectTest extends GroupFixture {

  @Test
  void oneThatIsActiveIsNotedUntilItsProcessIsDead() throws Exception {
    active();
    object.activate(false);
    system.unregisterObject(object);
    GroupStatus status = phoenix.status(0);
    assertThat(status.unregistered()).isEqualTo(1);
    ProcessHandle.of(status.pid()).orElseThrow().destroyForcibly();
    assertThat(awaitState(State.IDLE).unregistered()).isZero();
  }

  @Test
  void oneThatIsNotActiveIsNot() throws Exception {
    active();
    system.unregisterObject(object);
    assertThat(phoenix.status(0).unregistered()).isZero();
  }

  @Test
  void oneThatBecomesInactiveAfterwardsIsNotedNoLonger() throws Exception {
    FakeGroup fake = active();
    ActivationMonitor monitor = system.activeGroup(group, fake.proxy, 1);
    object.activate(false);
    system.unregisterObject(object);
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> monitor.inactiveObject(object));
    assertThat(phoenix.status(0).unregistered()).isZero();
  }

  @Test
  void oneThatIsJustBeingMadeIsNoted() throws Exception {
    FakeGroup fake = active();
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    fake.making =
        () -> {
          begun.countDown();
          await(release);
        };
    Future<?> activated = activate(object, false);
    begun.await();
    system.unregisterObject(object);
    assertThat(phoenix.status(0).unregistered()).isEqualTo(1);
    release.countDown();
    activated.get();
    assertThat(phoenix.status(0).unregistered()).isEqualTo(1);
  }

  @Test
  void anObjectThatMayExistThoughNoAnswerCameIsCounted() throws Exception {
    FakeGroup fake = active();
    fake.making =
        () -> {
          throw new RemoteException("no answer within 20000 ms; it may have run");
        };
    Future<?> activated = activate(object, false);
    assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
        .isThrownBy(activated::get);
    assertThat(phoenix.admin().unregisterInactive(object)).as("taken for inactive").isFalse();
    system.unregisterObject(object);
    assertThat(phoenix.status(0).unregistered()).isEqualTo(1);
  }

  private static void await(CountDownLatch latch) throws RemoteException {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new RemoteException("interrupted", e);
    }
  }
}
