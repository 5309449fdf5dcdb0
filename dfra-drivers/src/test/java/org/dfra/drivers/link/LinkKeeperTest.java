package org.dfra.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.link.LinkKeeper.BackOff;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

@Timeout(120)
class LinkKeeperTest {

  private static final Duration FIRST = Duration.ofSeconds(1);

  private final Logger log = (Logger) LoggerFactory.getLogger("dfra.test.keeper");
  private final ListAppender<ILoggingEvent> reported = new ListAppender<>();
  private final StepTicker ticker = new StepTicker(false);
  private final AtomicInteger tries = new AtomicInteger();
  private final ConcurrentLinkedQueue<ScriptedLink> links = new ConcurrentLinkedQueue<>();
  private final Talk talk = new Talk();
  private final LinkKeeper keeper =
      new LinkKeeper(
          "gps_front", this::open, talk, new BackOff(FIRST, FIRST.multipliedBy(4)), ticker, log);

  @BeforeEach
  void listen() {
    reported.list = new CopyOnWriteArrayList<>();
    reported.start();
    log.addAppender(reported);
    log.setAdditive(false);
  }

  @AfterEach
  void end() {
    keeper.close();
    log.detachAppender(reported);
  }

  private SerialLink open() throws IOException {
    tries.incrementAndGet();
    ScriptedLink link = links.poll();
    if (link == null) {
      throw new IOException("tcp://here:1: refused");
    }
    return link;
  }

  @Test
  void waitsLongerAndLongerAndLogsTheReasonOnce() {
    keeper.start();
    awaitTries(1);
    for (int seconds : new int[] {1, 2, 4, 4, 4}) {
      int before = tries.get();
      ticker.awaitWaiting();
      ticker.step(Duration.ofSeconds(seconds).minusNanos(1));
      Modules.await()
          .during(Duration.ofMillis(30))
          .until(() -> tries.get() == before); // a nanosecond is missing
      ticker.step(Duration.ofNanos(1));
      awaitTries(before + 1);
    }
    assertThat(messages()).containsExactly("tcp://here:1: refused; trying again until it answers");
  }

  @Test
  void logsEachChangeOnceHoweverManyTriesItTook() {
    ScriptedLink link = new ScriptedLink("tcp://here:1");
    keeper.start();
    awaitTries(1);
    ticker.awaitWaiting();
    ticker.step(FIRST);
    awaitTries(2);
    links.add(link);
    ticker.awaitWaiting();
    ticker.step(Duration.ofSeconds(2));
    link.say("one".getBytes());
    link.say("two".getBytes());
    Modules.await().until(() -> talk.texts.size() == 2);
    link.unplug();
    Modules.await().until(() -> talk.reasons.size() == 3);
    ticker.awaitWaiting();
    ticker.step(FIRST); // the first wait again, since the device had answered
    awaitTries(4);
    assertThat(messages())
        .containsExactly(
            "tcp://here:1: refused; trying again until it answers",
            "tcp://here:1: the device answers",
            "tcp://here:1: the device is lost; trying again until it answers",
            "tcp://here:1: refused; trying again until it answers");
  }

  @Test
  void keepsTheLinkThoughTheUserFailsByAnErrorWhenItIsLost() {
    talk.lostFails = new StackOverflowError("in lost");
    keeper.start();
    awaitTries(1);
    ticker.awaitWaiting();
    assertThat(keeper.fault())
        .isEqualTo(
            "tcp://here:1: refused; and the driver failed: java.lang.StackOverflowError: in lost");
    ticker.step(FIRST);
    awaitTries(2);
    assertThat(messages())
        .contains(
            "the driver failed when its link was lost: java.lang.StackOverflowError: in lost");
  }

  @Test
  void keepsTheLinkThoughTheUserFailsByAnErrorWhenItIsOpened() {
    links.add(new ScriptedLink("tcp://here:1"));
    talk.openedFails = new ExceptionInInitializerError("in opened");
    keeper.start();
    awaitTries(1);
    ticker.awaitWaiting();
    assertThat(talk.reasons)
        .containsExactly("the driver failed: java.lang.ExceptionInInitializerError: in opened");
    ticker.step(FIRST);
    awaitTries(2);
  }

  @Test
  void opensTheLinkAgainWhenItsHandlerComplains() {
    ScriptedLink silent = new ScriptedLink("tcp://here:1");
    links.add(silent);
    keeper.start();
    Modules.await().until(() -> talk.opened.size() == 1);
    talk.complaint = "no frame for 5 s";
    Modules.await().until(() -> talk.reasons.contains("tcp://here:1: no frame for 5 s"));
    assertThat(silent.isOpen()).isFalse();
  }

  @Test
  void survivesAUserThatThrows() {
    ScriptedLink first = new ScriptedLink("tcp://here:1");
    ScriptedLink second = new ScriptedLink("tcp://here:1");
    links.add(first);
    links.add(second);
    talk.throwOn = "boom";
    keeper.start();
    first.say("boom".getBytes());
    Modules.await().until(() -> talk.reasons.size() == 1);
    ticker.awaitWaiting();
    ticker.step(FIRST);
    second.say("fine".getBytes());
    Modules.await().until(() -> talk.texts.contains("fine"));
  }

  @Test
  void closeEndsTheReaderWhateverItDoes() {
    keeper.start();
    awaitTries(1); // it waits for the next try
    keeper.close();
    keeper.close();
    assertThat(readers()).isEmpty();
  }

  @Test
  void neverStartsAfterItWasClosed() {
    keeper.close();
    keeper.start();
    assertThat(readers()).isEmpty();
    assertThat(tries).hasValue(0);
  }

  @Test
  void theReaderIsNamedAfterItsModule() {
    keeper.start();
    keeper.start();
    awaitTries(1);
    assertThat(readers()).hasSize(1);
  }

  private void awaitTries(int count) {
    Modules.await().untilAsserted(() -> assertThat(tries).hasValue(count));
    Modules.await().until(() -> talk.reasons.size() + talk.opened.size() >= count);
  }

  private List<String> messages() {
    return reported.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  private static List<Thread> readers() {
    List<Thread> found = new ArrayList<>(Thread.getAllStackTraces().keySet());
    found.removeIf(thread -> !thread.getName().equals("gps_front reader") || !thread.isAlive());
    return found;
  }

  private static final class Talk implements LinkHandler {

    final List<SerialLink> opened = new CopyOnWriteArrayList<>();
    final List<String> texts = new CopyOnWriteArrayList<>();
    final List<String> reasons = new CopyOnWriteArrayList<>();
    volatile @Nullable String complaint;
    volatile String throwOn = "";
    volatile @Nullable Error lostFails;
    volatile @Nullable Error openedFails;

    @Override
    public void opened(SerialLink link) {
      opened.add(link);
      Error error = openedFails;
      if (error != null) {
        throw error;
      }
    }

    @Override
    public boolean received(byte[] bytes, int length) {
      String text = new String(bytes, 0, length);
      if (text.equals(throwOn)) {
        throw new IllegalStateException("a fault in the driver");
      }
      texts.add(text);
      return true;
    }

    @Override
    public @Nullable String periodic(SerialLink link) {
      return complaint;
    }

    @Override
    public void lost(String reason) {
      reasons.add(reason);
      Error error = lostFails;
      if (error != null) {
        throw error;
      }
    }
  }
}
