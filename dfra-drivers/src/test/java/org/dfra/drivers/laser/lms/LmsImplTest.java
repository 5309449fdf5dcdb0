package org.dfra.drivers.laser.lms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.parameter;
import static org.dfra.drivers.fixture.Modules.texts;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.slf4j.LoggerFactory;

/** The driver alone: the test is the laser and the time. */
@Timeout(120)
class LmsImplTest {

  private static final String URL = "tcp://laser:4001";
  private static final Instant HOST = Instant.parse("2026-01-21T07:33:29Z");
  private static final LmsVariant USUAL = new LmsVariant(180, 50);
  private static final byte[] DONE = Replies.acknowledged(Replies.telegram(0xA0, 0));
  private static final byte[] SCAN = Replies.scan(1, samples(361, 2500));

  private final StepTicker ticker = new StepTicker(false);
  private final ScriptedLinks links = new ScriptedLinks(URL);
  private final ListAppender<ILoggingEvent> reported = new ListAppender<>();
  private final Logger log = (Logger) LoggerFactory.getLogger("dfra.atrv1.laser");
  private ScriptedLink link = new ScriptedLink(URL);
  private LmsImpl laser;
  private int received; // of the commands written

  @BeforeEach
  void listen() {
    reported.list = new CopyOnWriteArrayList<>();
    reported.start();
    log.addAppender(reported);
    log.setAdditive(false);
  }

  @AfterEach
  void end() {
    laser.close();
    log.detachAppender(reported);
  }

  @Test
  void asksWhatThereIsAndHasItStream() {
    start();
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), Replies.telegram(0xBA, 'L', 'M', 'S'));
    answer(LmsCommands.configuration(), configuration(0xF4, 0, 1));
    answer(LmsCommands.stream(), DONE);
    link.say(SCAN);
    awaitReadiness(Readiness.READY);
    RangeScan scan = laser.scan();
    assertThat(scan.range(17)).isEqualTo(2.5f);
    // a scan takes a turn and a half; its telegram of 732 bytes at 38 400 baud takes 190.625 ms
    assertThat(Duration.between(scan.measured(), HOST)).isEqualTo(Duration.ofNanos(210_625_000));
    assertThat(scan.duration()).isEqualTo(1.5 / 75);
  }

  @Test
  void configuresWhatDiffersAndLeavesTheRestAsItIs() {
    start("resolution", "1", "measuring_mode", "3");
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), Replies.telegram(0xBA, 'L'));
    answer(LmsCommands.configuration(), configuration(0xF4, 0, 0));
    answer(LmsCommands.installation(), DONE);
    LmsConfiguration wanted = parsed(configuration(0xF4, 3, 1));
    answer(LmsCommands.configure(wanted), configuration(0xF7, 3, 1));
    answer(LmsCommands.configuration(), configuration(0xF4, 3, 1));
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.variant(new LmsVariant(180, 100)), variant(1, 180, 100));
    answer(LmsCommands.stream(), DONE);
    link.say(Replies.scan(1, samples(181, 16_000)));
    awaitReadiness(Readiness.READY);
    assertThat(laser.scan().range(0)).as("14 bits").isEqualTo(16f);
    assertThat(parameter(laser, "flash_writes")).isEqualTo("1");
  }

  @Test
  void asksAgainAtOnceWhatTheLaserCouldNotRead() {
    start();
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), new byte[] {0x15});
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), new byte[] {0x15});
    awaitCommand(LmsCommands.type());
  }

  @Test
  void asksThreeTimesAndThenSearchesIt() {
    start();
    answer(LmsCommands.stop(), DONE);
    for (int tries = 0; tries < 3; tries++) {
      awaitCommand(LmsCommands.status());
      ticker.step(Duration.ofMillis(1500));
    }
    answer(LmsCommands.stop(), DONE);
    awaitCommand(LmsCommands.status());
    assertWarned("the laser was asked how it is and does not answer any more");
  }

  @Test
  void doesWithoutWhatAnOldLaserDoesNotKnow() {
    start();
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), Replies.telegram(0x92));
    answer(LmsCommands.configuration(), configuration(0xF4, 0, 1));
    answer(LmsCommands.stream(), DONE);
    assertWarned("the laser was asked what it is and refuses");
  }

  @Test
  void searchesAtEverySpeedAndFollowsTheLaserToTheWantedOne() {
    start("baud", "38400");
    for (int baud : new int[] {38_400, 9600}) {
      awaitCommand(LmsCommands.stop());
      assertThat(link.bauds()).endsWith(baud);
      if (baud != 9600) {
        ticker.step(Duration.ofMillis(1500));
      }
    }
    link.say(DONE);
    answer(LmsCommands.status(), status(0x8067, 180, 50));
    awaitCommand(LmsCommands.baud(LmsBaud.B38400));
    assertThat(link.bauds()).as("tried, and put back").containsExactly(38_400, 9600, 38_400, 9600);
    link.say(DONE);
    await().until(() -> link.bauds().size() == 5);
    assertThat(link.bauds()).endsWith(38_400);
    int sent = link.written().size();
    ticker.step(Duration.ofMillis(249));
    link.say(new byte[] {0}); // a look at the time
    await().until(() -> parameter(laser, "dropped_bytes").equals("1"));
    assertThat(link.written()).as("both ends are left alone").hasSize(sent);
    ticker.step(Duration.ofMillis(1));
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    awaitCommand(LmsCommands.type());
  }

  @Test
  void doesNotRetryForEverWhereALaserDoesNotChangeItsSpeed() {
    start("baud", "38400");
    answer(LmsCommands.stop(), DONE);
    for (int tries = 0; tries < 3; tries++) {
      answer(LmsCommands.status(), status(0x8067, 180, 50));
      answer(LmsCommands.baud(LmsBaud.B38400), DONE);
      int set = 1 + 3 * (tries + 1);
      await().until(() -> link.bauds().size() == set);
      ticker.step(Duration.ofMillis(250));
    }
    answer(LmsCommands.status(), status(0x8067, 180, 50));
    awaitCommand(LmsCommands.type());
  }

  @Test
  void writesTheFlashThreeTimesAtMostHoweverOftenItIsInVain() {
    start();
    for (int opening = 1; opening <= 4; opening++) {
      answer(LmsCommands.stop(), DONE);
      answer(LmsCommands.status(), status(0x8019, 180, 50));
      answer(LmsCommands.type(), Replies.telegram(0xBA, 'L'));
      answer(LmsCommands.configuration(), configuration(0xF4, 0, 0));
      if (opening <= 3) {
        answer(LmsCommands.installation(), DONE);
        LmsConfiguration wanted = parsed(configuration(0xF4, 0, 1));
        answer(LmsCommands.configure(wanted), configuration(0xF7, 0, 0));
        answer(LmsCommands.configuration(), configuration(0xF4, 0, 0));
        answer(LmsCommands.stop(), DONE);
      }
      awaitCommand(LmsCommands.stream());
      ScriptedLink next = links.add();
      link.unplug();
      await()
          .until(
              () -> {
                ticker.step(Duration.ofMillis(500)); // until it is opened again
                return !next.written().isEmpty();
              });
      link = next;
      received = 0;
    }
    assertThat(parameter(laser, "flash_writes")).isEqualTo("3");
    assertWarned("the laser's flash was written, but the laser still has measuring mode 0 in cm");
  }

  @Test
  void doubtsWhatItKnowsWhenAScanDoesNotFit() {
    streams();
    link.say(SCAN);
    awaitReadiness(Readiness.READY);
    link.say(Replies.scan(1, samples(181, 1000)));
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(laser::scan)
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("181 beams came, where 180° by 0.5° was set");
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 100));
    answer(LmsCommands.configuration(), configuration(0xF4, 0, 1));
    answer(LmsCommands.variant(USUAL), variant(1, 180, 50));
    answer(LmsCommands.stream(), DONE);
    link.say(SCAN);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void readsNoScansOfAMeasuringModeThatNobodyKnows() {
    start();
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), Replies.telegram(0xBA, 'L'));
    answer(LmsCommands.configuration(), configuration(0xF4, 9, 1));
    answer(LmsCommands.status(), status(0x8019, 180, 50)); // a sign of life
    await()
        .untilAsserted(
            () ->
                assertThatThrownBy(laser::scan)
                    .hasMessageContaining("its measuring mode is 9")
                    .hasMessageContaining("set measuring_mode"));
  }

  @Test
  void servesNoScanThatIsTooOld() {
    streams();
    link.say(SCAN);
    awaitReadiness(Readiness.READY);
    assertThat(laser.scan().beams()).isEqualTo(361);
    ticker.step(Duration.ofMillis(1100)); // three periods are 572 ms, and a half second
    assertThatThrownBy(laser::scan)
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("its last scan is 1.1 s old, and none older than 1.072 s is served");
    ticker.step(Duration.ofMillis(1600));
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(laser::scan).hasMessageContaining(URL + ": no scan for 2.572 s");
  }

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 0})
  void outlivesALaserThatSaysAnything(long given) {
    long seed = given == 0 ? Long.getLong("dfra.seed", new Random().nextLong()) : given;
    Random random = new Random(seed);
    start("baud", "38400");
    int[] replies = {0x90, 0x91, 0x92, 0xA0, 0xB0, 0xB1, 0xB2, 0xBA, 0xBB, 0xF4, 0xF7, 0x80};
    for (int i = 0; i < 2000; i++) {
      int length = random.nextInt(4) == 0 ? 152 : random.nextInt(40);
      int[] data = random.ints(length, 0, random.nextBoolean() ? 2 : 256).toArray();
      link.say(Replies.telegram(replies[random.nextInt(replies.length)], data));
      if (random.nextInt(20) == 0) {
        link.awaitLooked(); // else the time runs away from it, and it gives a silent laser up
        ticker.step(Duration.ofMillis(random.nextInt(700)));
      }
    }
    await("-Ddfra.seed=" + seed).until(() -> Integer.parseInt(parameter(laser, "frames")) >= 2000);
    assertThat(reported.list)
        .as("-Ddfra.seed=%d", seed)
        .noneMatch(event -> event.getLevel() == Level.ERROR);
    laser.close();
    assertThat(laser.readiness()).isEqualTo(Readiness.STOPPED);
  }

  private void streams() {
    start("idle_timeout", "0");
    answer(LmsCommands.stop(), DONE);
    answer(LmsCommands.status(), status(0x8019, 180, 50));
    answer(LmsCommands.type(), Replies.telegram(0xBA, 'L'));
    answer(LmsCommands.configuration(), configuration(0xF4, 0, 1));
    answer(LmsCommands.stream(), DONE);
  }

  private void start(String... parameters) {
    Map<String, String> all = texts("link", URL);
    all.putAll(texts(parameters));
    links.add(link);
    laser = new LmsImpl(context("laser", all, () -> HOST), ticker, links);
    laser.start();
  }

  /** Waits for the next command, which must be this one, and answers it. */
  private void answer(byte[] command, byte[] reply) {
    awaitCommand(command);
    link.say(reply);
  }

  private void awaitCommand(byte[] command) {
    await().until(() -> link.written().size() > received);
    assertThat(link.written().get(received)).as("command %d", received).isEqualTo(command);
    received++;
  }

  private static LmsConfiguration parsed(byte[] telegram) {
    return ((LmsMessage.ConfigurationReply) LmsParser.parse(telegram).get(0)).configuration();
  }

  private static byte[] configuration(int command, int mode, int unit) {
    int from = command == 0xF7 ? 1 : 0;
    int[] data = new int[from + 34];
    data[0] = from;
    data[from + 3] = 70; // a field that the driver does not know
    data[from + 5] = mode;
    data[from + 6] = unit;
    return Replies.acknowledged(Replies.telegram(command, data));
  }

  private static byte[] variant(int done, int degrees, int hundredths) {
    return Replies.acknowledged(Replies.telegram(0xBB, done, degrees, 0, hundredths, 0));
  }

  private static byte[] status(int baud, int degrees, int hundredths) {
    int[] data = new int[152];
    data[106] = degrees;
    data[108] = hundredths;
    data[115] = baud & 0xFF;
    data[116] = baud >> 8;
    return Replies.acknowledged(Replies.telegram(0xB1, data));
  }

  private static int[] samples(int beams, int value) {
    int[] samples = new int[beams];
    java.util.Arrays.fill(samples, value);
    return samples;
  }

  private void assertWarned(String sentence) {
    List<String> all = reported.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
    assertThat(all).anyMatch(line -> line.contains(sentence));
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(laser, expected);
  }
}
