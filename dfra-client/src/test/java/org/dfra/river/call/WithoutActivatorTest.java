package org.dfra.river.call;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.rmi.ConnectException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

/** What a proxy does when its object may be dead and the activator does not help. */
class WithoutActivatorTest extends ResurrectionFixture {

  private void activatorIsOutOfReach() {
    id.activating =
        force -> {
          throw new ConnectException("nobody there");
        };
  }

  @Test
  void withoutAnActivatorALinkThatCameBackServesTheSameCall() throws Exception {
    activatorIsOutOfReach();
    ConnectException cut = new ConnectException("cut");
    assertThat(proxy(live("alive", cut)).change())
        .as("a command that has not run")
        .isEqualTo("alive");
    assertThat(proxy(live("alive", new UnmarshalException("cut"))).read())
        .as("a question that may have run")
        .isEqualTo("alive");
  }

  @Test
  void withoutAnActivatorTheProxyThatFailedIsTriedByTheNextCall() throws Exception {
    activatorIsOutOfReach();
    for (RemoteException end :
        List.of(new DeadlineExceededException("late"), new UnmarshalException("cut"))) {
      Service service = proxy(live("alive", end));
      assertThatExceptionOfType(end.getClass()).isThrownBy(service::change).isSameAs(end);
      id.asked.clear();
      assertThat(service.change()).as("the call after %s", end).isEqualTo("alive");
      assertThat(id.asked).as("activations before it").containsExactly(false);
      assertThat(service.change()).isEqualTo("alive");
      assertThat(id.asked).as("what answered is trusted again").hasSize(1);
    }
  }

  @Test
  void withoutAnActivatorWhatTheObjectItselfThrowsIsAnAnswer() {
    activatorIsOutOfReach();
    IllegalStateException own = new IllegalStateException("its own");
    Service service = proxy(live("alive", new DeadlineExceededException("late"), own, own));
    assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
    assertThatExceptionOfType(IllegalStateException.class)
        .isThrownBy(service::change)
        .isSameAs(own);
    assertThatExceptionOfType(IllegalStateException.class)
        .isThrownBy(service::change)
        .isSameAs(own);
    assertThat(id.asked).as("what answered is trusted again").hasSize(1);
  }

  @Test
  void withoutAnActivatorACommandIsNeverSentAgainOnceItMayHaveRun() throws Exception {
    activatorIsOutOfReach();
    UnmarshalException broke = new UnmarshalException("cut on the way back");
    Live alive = new Live("alive", null, new ConnectException("cut"), broke);
    Service service = proxy(proxyOf(alive));
    assertThatExceptionOfType(UnmarshalException.class).isThrownBy(service::change).isSameAs(broke);
    assertThat(alive.calls()).as("one that did not run, one that may have").isEqualTo(2);
  }

  @Test
  void withoutAnActivatorADeadObjectIsReportedWithBothReasons() {
    activatorIsOutOfReach();
    ConnectException refused = new ConnectException("refused");
    Live dead = new Live("dead", null, refused, refused, refused);
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(proxyOf(dead)).read())
        .withMessageContaining("the activation system cannot be reached")
        .satisfies(reported -> assertThat(reported.getSuppressed()).containsExactly(refused));
    assertThat(dead.calls()).isEqualTo(2);

    NoSuchObjectException no = new NoSuchObjectException("no such object");
    Live closed = new Live("closed", null, no, no);
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(proxyOf(closed)).read())
        .satisfies(reported -> assertThat(reported.getSuppressed()).containsExactly(no));
    assertThat(closed.calls()).as("who says no is not asked again").isEqualTo(1);
  }

  @Test
  void silentActivatorKeepsNobodyFromAnObjectThatLives() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    id.activating =
        force -> {
          await("the end of the test").forever().until(() -> never.getCount() == 0);
          throw new DeadlineExceededException("no answer");
        };
    try {
      Service service = proxy(live("alive", new DeadlineExceededException("late")));
      assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
      assertThat(service.change()).isEqualTo("alive");
      assertThat(never.getCount()).as("the activator has not answered").isEqualTo(1);
    } finally {
      never.countDown();
    }
  }

  @Test
  void slowActivatorIsWaitedForWhereTheObjectIsDead() throws Exception {
    Live dead =
        new Live("dead", null, new DeadlineExceededException("late"), new ConnectException("x"));
    id.activating =
        force -> {
          await("the last proxy is tried").atMost(30, SECONDS).until(() -> dead.calls() == 2);
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(proxyOf(dead));
    assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
    assertThat(service.change()).isEqualTo("new");
    assertThat(id.asked).containsExactly(false);
  }
}
