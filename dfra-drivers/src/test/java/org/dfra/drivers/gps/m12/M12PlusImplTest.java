package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDateTime;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.Frames;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.link.SerialLink;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.slf4j.LoggerFactory;

/** The driver alone: the test is the receiver and the time. */
@Timeout(30)
class M12PlusImplTest {

  private static final String URL = "tcp://receiver:4001";
  private static final LocalDateTime TIME = LocalDateTime.of(2026, 1, 21, 7, 33, 29);
  private static final Instant HOST = Instant.parse("2026-01-21T07:33:29.400Z");
  private static final byte[] FIX = Frames.ha(TIME, 52.91, 6.86, Frames.FIX_3D);
  private static final byte[] NO_FIX = Frames.ha(TIME, 0, 0, Frames.ACQUIRING);

  /** How many commands the driver sends when the link is open. */
  private static final int ORDERS = 9;

  private final StepTicker ticker = new StepTicker(false);
  private final ConcurrentLinkedQueue<ScriptedLink> links = new ConcurrentLinkedQueue<>();
  private final AtomicInteger opened = new AtomicInteger();
  private final ListAppender<ILoggingEvent> told = new ListAppender<>();
  private final Logger log = (Logger) LoggerFactory.getLogger("dfra.atrv1.gps_front");
  private final ScriptedLink link = new ScriptedLink(URL);
  private final M12PlusImpl gps = driver(Map.of("link", URL));

  @BeforeEach
  void listen() {
    told.list = new CopyOnWriteArrayList<>();
    told.start();
    log.addAppender(told);
    log.setAdditive(false);
    links.add(link);
  }

  @AfterEach
  void end() {
    gps.close();
    log.detachAppender(told);
  }

  @Test
  void asksWhatItIsSetsItToASafeStateAndOrdersWhatItWants() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    assertThat(link.written())
        .containsExactly(
            M12Commands.identification(),
            M12Commands.utcTime(),
            M12Commands.positionControl(PositionControl.Mode.POSITION_3D),
            M12Commands.positionOf12Channels(1),
            M12Commands.timeRaimOn(),
            M12Commands.timeRaimOf12Channels(1),
            M12Commands.visibleSatellites(true),
            M12Commands.utcOffset(),
            M12Commands.askHoldPosition());
  }

  @Test
  void repeatsWhatIsNotAcknowledgedAndThenSaysSo() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    link.say(M12Commands.utcTime());
    link.say(M12Commands.timeRaimOn());
    await().until(() -> gps.counts().frames() == 3);
    for (int tries = 1; tries < 3; tries++) {
      ticker.step(Duration.ofSeconds(3).plusNanos(1));
      link.say(FIX);
      int expected = ORDERS + tries;
      await().until(() -> link.written().size() == expected);
      assertThat(link.written().get(expected - 1))
          .isEqualTo(M12Commands.positionControl(PositionControl.Mode.POSITION_3D));
    }
    ticker.step(Duration.ofSeconds(3).plusNanos(1));
    link.say(FIX);
    await()
        .untilAsserted(
            () ->
                assertThat(warnings())
                    .containsExactly(
                        "atrv1/gps_front: the receiver has not acknowledged @@Gd, which it"
                            + " should"));
    assertThat(link.written()).hasSize(ORDERS + 2);
  }

  @Test
  void tellsTheReceiverWhatToSolveForWhileItRuns() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    assertThatThrownBy(() -> gps.setParameter("positioning", "guess"))
        .hasMessageContaining(
            "cannot be \"guess\", which is not position_3d, altitude_hold, hold or survey");
    gps.setParameter("positioning", "altitude_hold");
    await().until(() -> link.written().size() == ORDERS + 1);
    assertThat(link.written().get(ORDERS))
        .isEqualTo(M12Commands.positionControl(PositionControl.Mode.ALTITUDE_HOLD));
  }

  @Test
  void shortPositionsKnowUtcByOtherMessages() {
    ScriptedLink brief = new ScriptedLink(URL);
    links.clear();
    links.add(brief);
    try (M12PlusImpl driver = driver(Map.of("link", URL, "positions", "short"))) {
      driver.start();
      brief.say(Frames.hb(TIME, 52.91, 6.86, Frames.FIX_3D));
      await().until(() -> driver.readiness() == Readiness.READY);
      assertThat(brief.written()).contains(M12Commands.shortPosition(1));
      assertThat(driver.fix().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
      assertThatThrownBy(driver::time).hasMessageContaining("has not yet learned");
      brief.say(M12Commands.utcTime());
      brief.say(M12Commands.encode("Bo", 18));
      brief.say(Frames.hb(TIME, 52.91, 6.86, Frames.FIX_3D));
      await().until(() -> driver.counts().frames() == 4);
      await()
          .untilAsserted(() -> assertThat(driver.time().utc()).isEqualTo("2026-01-21T07:33:29Z"));
      assertThat(parameter(driver, "utc_offset")).isEqualTo("18");
    }
  }

  @Test
  void showsSatellitesAndIntegrity() {
    gps.start();
    assertThat(parameter(gps, "integrity")).isEqualTo("not told");
    byte[] fix = Frames.with(FIX, 57, 14 << 24 | 8 << 16 | 47 << 8, 4);
    link.say(Frames.with(fix, 63, 23 << 24 | 1 << 16, 4));
    int[] visible = new int[85];
    visible[0] = 2;
    System.arraycopy(new int[] {14, 0, 0, 41, 0, 60, 0}, 0, visible, 1, 7);
    System.arraycopy(new int[] {9, 0, 0, 5, 1, 4, 0}, 0, visible, 8, 7);
    link.say(M12Commands.encode("Bb", visible));
    int[] raim = new int[71];
    raim[2] = 1; // alarm
    raim[9] = 54;
    link.say(M12Commands.encode("Hn", raim));
    await().until(() -> gps.counts().frames() == 3);
    await()
        .untilAsserted(
            () ->
                assertThat(parameter(gps, "satellites"))
                    .isEqualTo(
                        "3 in view, 1 heard, 1 used: G14 41° up, 60° from north, 47 dB-Hz, used;"
                            + " G23 not heard; G09 5° up, 260° from north, not heard"));
    assertThat(gps.test("integrity").finding())
        .isEqualTo(
            "ALARM, a wrong satellite would be detected and taken out, time accurate to 54 ns");
    assertThat(gps.test("integrity").passed()).isFalse();
    assertThat(gps.test("satellites").passed()).as("one is too few").isFalse();
  }

  @Test
  void becomesReadyWithTheFirstPosition() {
    assertThat(gps.readiness()).isEqualTo(Readiness.CREATED);
    gps.start();
    link.say(NO_FIX);
    await().until(() -> gps.counts().frames() == 1);
    assertThat(gps.readiness()).isEqualTo(Readiness.INITIALIZING);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(gps.location().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
    assertThat(gps.location().frame()).isEqualTo("atrv1/gps_front");
    assertThat(gps.location().measured()).isEqualTo("2026-01-21T07:33:29Z");
    assertThat(gps.time()).isEqualTo(new TimeReading(Instant.parse("2026-01-21T07:33:29Z"), HOST));
    assertThat(gps.time().hostOffset()).isEqualTo(Duration.ofMillis(400));
    assertThat(gps.updateRate()).isEqualTo(1);
  }

  @Test
  void saysWhatItWaitsForBeforeTheFirstPosition() {
    assertRefuses(gps::fix, "atrv1/gps_front is CREATED: it has not been started");
    gps.start();
    await().until(() -> !link.written().isEmpty());
    assertRefuses(
        gps::location,
        "atrv1/gps_front is INITIALIZING: " + URL + " is open, no position frame has come yet");
    link.say(NO_FIX);
    await().until(() -> gps.counts().frames() == 1);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::time,
                    "atrv1/gps_front is INITIALIZING: the receiver has no position yet, it is"
                        + " acquiring satellites, 0 of 0 tracked"));
    gps.close();
    assertRefuses(gps::fix, "atrv1/gps_front is STOPPED: it has ended");
  }

  @Test
  void tellsNoTimeBeforeItKnowsUtc() {
    gps.start();
    link.say(Frames.with(FIX, 141, 0x80, 1));
    awaitReadiness(Readiness.READY);
    assertThat(gps.location().position().latitude()).isEqualTo(52.91);
    assertThatThrownBy(gps::time)
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("has not yet learned from the satellites");
  }

  @Test
  void refusesAPositionThatIsTooOldEvenBeforeTheReaderNotices() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    ticker.step(Duration.ofSeconds(5)); // three periods and 2 s
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    ticker.step(Duration.ofNanos(1));
    assertThatThrownBy(gps::fix).isInstanceOf(NotReadyException.class);
  }

  @Test
  void aSilentReceiverIsOpenedAnew() {
    ScriptedLink second = new ScriptedLink(URL);
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    links.add(second);
    ticker.step(Duration.ofSeconds(5).plusNanos(1));
    awaitReadiness(Readiness.INITIALIZING);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::fix,
                    "atrv1/gps_front is INITIALIZING: " + URL + ": no position frame for 5 s"));
    assertThat(link.isOpen()).isFalse();
    ticker.step(Duration.ofMillis(500));
    await().until(() -> second.written().size() == ORDERS); // told again what to send
    second.say(FIX);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void silenceIsMeasuredInPeriodsOfTheSetRate() {
    ScriptedLink slow = new ScriptedLink(URL);
    links.clear();
    links.add(slow);
    try (M12PlusImpl driver = driver(Map.of("link", URL, "rate", "10"))) {
      assertThat(driver.updateRate()).isEqualTo(0.1);
      driver.start();
      slow.say(FIX);
      await().until(() -> driver.readiness() == Readiness.READY);
      assertThat(slow.written()).contains(M12Commands.positionOf12Channels(10));
      ticker.step(Duration.ofSeconds(32));
      assertThat(driver.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      ticker.step(Duration.ofNanos(1));
      await().until(() -> driver.readiness() == Readiness.INITIALIZING);
    }
  }

  @Test
  void aReceiverWithoutSatellitesKeepsItsLinkButNotItsReadiness() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    for (int second = 0; second < 5; second++) {
      ticker.step(Duration.ofSeconds(1));
      link.say(NO_FIX);
      int frames = second + 2;
      await().until(() -> gps.counts().frames() == frames);
      assertThat(gps.readiness()).isEqualTo(Readiness.READY);
    }
    await().until(() -> gps.fix().mode() == GpsFix.Mode.NONE);
    assertThat(gps.location().position().latitude()).isEqualTo(52.91); // still fresh enough
    ticker.step(Duration.ofNanos(1));
    awaitReadiness(Readiness.INITIALIZING);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::location,
                    "atrv1/gps_front is INITIALIZING: the receiver has no position, it is"
                        + " acquiring satellites, 0 of 0 tracked"));
    assertThat(link.isOpen()).isTrue();
    assertThat(opened).hasValue(1);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void anUnpluggedReceiverIsOpenedAgainWhenItIsBack() {
    ScriptedLink second = new ScriptedLink(URL);
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    link.unplug();
    awaitReadiness(Readiness.INITIALIZING);
    for (int tries = 2; tries < 7; tries++) {
      int expected = tries;
      ticker.step(Duration.ofSeconds(8)); // the longest wait
      await().until(() -> opened.get() >= expected);
    }
    links.add(second);
    ticker.step(Duration.ofSeconds(8));
    second.say(FIX);
    awaitReadiness(Readiness.READY);
    assertThat(warnings())
        .containsExactly(
            URL + ": the device is lost; trying again until it answers",
            URL + ": refused; trying again until it answers");
  }

  @Test
  void asksAnEightChannelReceiverForWhatItHas() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    ticker.step(Duration.ofSeconds(2).plusNanos(1));
    await().until(() -> link.written().size() == ORDERS + 3);
    assertThat(link.written().subList(ORDERS, ORDERS + 3))
        .containsExactly(
            M12Commands.holdOff(),
            M12Commands.positionOf8Channels(1),
            M12Commands.timeRaimOf8Channels(1));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x20));
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(57.71, 12.02, 0));
    assertThat(gps.time().utc()).isEqualTo("2026-01-21T07:33:29Z");
    await().until(() -> Integer.valueOf(8).equals(gps.receiver().channels()));
  }

  @Test
  void prefersTwelveChannelsToEightAndStopsTheEight() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    ticker.step(Duration.ofSeconds(2).plusNanos(1));
    await().until(() -> link.written().size() == ORDERS + 3);
    link.say(FIX);
    await().until(() -> link.written().size() == ORDERS + 5);
    assertThat(link.written().get(ORDERS + 3)).isEqualTo(M12Commands.positionOf8Channels(0));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x20));
    await().until(() -> gps.counts().frames() == 2);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
    assertThat(gps.receiver().channels()).isEqualTo(12);
  }

  @Test
  void remembersWhatTheReceiverIs() {
    assertThat(gps.identified()).isEmpty();
    gps.start();
    int[] payload = new int[287];
    for (int i = 0; i < payload.length; i++) {
      payload[i] = i < 13 ? "MODEL #  P283".charAt(i) : ' ';
    }
    link.say(M12Commands.encode("Cj", payload));
    await().until(() -> gps.identified().isPresent());
    assertThat(gps.identified().orElseThrow().model()).isEqualTo("P283");
    assertThat(gps.identification().description()).contains("M12+");
  }

  @Test
  void countsMalformedFramesAndReportsTheFirst() {
    byte[] impossible = Frames.with(FIX, 15, 200 * 3_600_000, 4);
    gps.start();
    link.say(impossible);
    link.say(impossible);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    assertThat(gps.counts()).isEqualTo(new StreamCounts(3, 0, 2));
    assertThat(warnings())
        .singleElement()
        .asString()
        .startsWith("malformed @@Ha: latitude (mas) 720000000 is outside");
  }

  @Test
  void aStormOfGarbageCostsNothingButItsBytes() {
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    gps.start();
    long garbage = 0;
    for (int i = 0; i < 200; i++) {
      byte[] storm = new byte[1 + random.nextInt(4000)];
      random.nextBytes(storm);
      garbage += storm.length;
      link.say(storm);
    }
    link.say(FIX);
    link.say(FIX); // a false head in the last of the garbage may hold back the first
    link.say(FIX);
    await("seed " + seed).until(() -> gps.readiness() == Readiness.READY);
    long dropped = garbage;
    await("seed " + seed).until(() -> gps.counts().droppedBytes() == dropped);
  }

  @Test
  void garbageIsNoSignOfLife() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    for (int second = 0; second < 6; second++) {
      link.say(new byte[500]);
      ticker.step(Duration.ofSeconds(1));
    }
    awaitReadiness(Readiness.INITIALIZING);
    assertThat(link.isOpen()).isFalse();
  }

  @Test
  void endsCompletelyAndAtOnceInEveryState() {
    gps.start();
    gps.close();
    gps.close();
    gps.start();
    assertThat(gps.readiness()).isEqualTo(Readiness.STOPPED);
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().equals("gps_front reader"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "link | | parameter link is not set",
        "link | udp://x:1 | parameter link is \"udp://x:1\", which is not a usable link: link",
        "rate | 0 | parameter rate is \"0\", which is not a number from 1 to 255",
        "positioning | fast | parameter positioning is \"fast\", which is not position_3d, altitude_hold",
        "positions | none | parameter positions is \"none\", which is not full or short",
        "rate | 1.5 | parameter rate is \"1.5\", which is not a whole number of seconds",
        "reopen_first | 9 | parameter reopen_first is \"9\", which is not in order: reopen_first is",
      })
  void refusesWrongParametersWithTheirPlace(String name, String value, String sentence) {
    Map<String, String> texts = new HashMap<>(Map.of("link", URL));
    texts.put(name, value);
    texts.values().removeIf(text -> text == null);
    assertThatThrownBy(() -> driver(texts))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("atrv1/gps_front: " + sentence);
  }

  private M12PlusImpl driver(Map<String, String> texts) {
    ModuleContext context =
        new ModuleContext(
            "atrv1", "gps_front", Parameters.of("atrv1/gps_front", texts), () -> HOST);
    return new M12PlusImpl(context, ticker, this::open);
  }

  private SerialLink open() throws IOException {
    opened.incrementAndGet();
    ScriptedLink next = links.poll();
    if (next == null) {
      throw new IOException(URL + ": refused");
    }
    return next;
  }

  private static String parameter(M12PlusImpl driver, String name) {
    return driver.parameters().stream()
        .filter(parameter -> parameter.name().equals(name))
        .findFirst()
        .orElseThrow()
        .text();
  }

  private void awaitReadiness(Readiness expected) {
    await().untilAsserted(() -> assertThat(gps.readiness()).isEqualTo(expected));
  }

  private List<String> warnings() {
    return told.list.stream()
        .filter(event -> event.getLevel().isGreaterOrEqual(Level.WARN))
        .map(ILoggingEvent::getFormattedMessage)
        .toList();
  }

  private static void assertRefuses(ThrowingCallable ask, String message) {
    assertThatThrownBy(ask).isInstanceOf(NotReadyException.class).hasMessage(message);
  }
}
