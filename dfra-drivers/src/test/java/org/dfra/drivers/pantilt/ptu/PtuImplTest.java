package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.parameter;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.core.config.ConfigurationException;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.Halt;
import org.dfra.flow.effector.PanTiltCommand.Point;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.PanTiltAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver alone: the test is the unit and the time. */
@Timeout(120)
class PtuImplTest {

  private static final String URL = "tcp://unit:4001";
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
  private static final double POSITION = Math.toRadians(185.1428 / 3600);

  /** What a PTU-46-17.5 says. */
  private static final Map<String, String> ANSWERS =
      Map.of(
          "PR",
          "185.1428",
          "TR",
          "185.1428",
          "PN",
          "-3090",
          "PX",
          "3090",
          "TN",
          "-907",
          "TX",
          "604",
          "PL",
          "31",
          "PU",
          "2902",
          "TL",
          "31",
          "TU",
          "2902");

  private static final List<String> QUESTIONS =
      List.of("PR", "TR", "PN", "PX", "TN", "TX", "PL", "PU", "TL", "TU");

  private final StepTicker ticker = new StepTicker(false);
  private final ScriptedLinks links = new ScriptedLinks(URL);
  private final Map<String, String> answers = new HashMap<>(ANSWERS);
  private ScriptedLink link = new ScriptedLink(URL);
  private int heard; // pieces that the driver wrote
  private final PtuImpl unit = driver(Map.of("link", URL, "mount_x", "0.2"));

  @BeforeEach
  void start() {
    links.add(link);
    unit.start();
  }

  @AfterEach
  void end() {
    unit.close();
  }

  @Test
  void setsTheUnitUpAndAsksWhatItCan() {
    awaitWords();
    assertThat(next()).isEqualTo("ED ");
    assertThat(next()).isEqualTo("FT ");
    assertThat(next()).isEqualTo("I ");
    say("ED *\r\nFT *\r\n*\r\n");
    for (String question : QUESTIONS) {
      assertThat(next()).isEqualTo(question + " ");
      say("* " + ANSWERS.get(question) + "\r\n");
    }
    assertThat(next()).isEqualTo("PP ");
    say("* 100\r\n");
    assertThat(next()).isEqualTo("TP ");
    say("* -50\r\n");
    awaitReadiness(Readiness.READY);
    assertThat(unit.panTilt().pan()).isCloseTo(100 * POSITION, within(1e-12));
    assertThat(unit.panTilt().tilt()).isCloseTo(-50 * POSITION, within(1e-12));
    assertThat(unit.panTilt().isMoving()).isFalse();
    assertThat(unit.panTilt().frame()).isEqualTo("atrv1/pan_tilt");
    assertThat(unit.localTransform().x()).isEqualTo(0.2);
    assertThat(unit.localTransform().pitch()).as("down").isCloseTo(50 * POSITION, within(1e-9));
  }

  @Test
  void tellsNothingBeforeTheUnitDoes() {
    assertThatThrownBy(unit::panTilt)
        .isInstanceOf(NotReadyException.class)
        .hasMessageStartingWith("atrv1/pan_tilt is INITIALIZING");
    assertThatThrownBy(unit::localTransform).isInstanceOf(NotReadyException.class);
    assertThat(unit.attributes()).noneMatch(PanTiltAttributes.class::isInstance);
  }

  @Test
  void pointsTheHeadAndSaysWhileItMoves() throws Exception {
    beReady();
    assertThat(unit.attributes())
        .anySatisfy(
            each -> {
              assertThat(each).isInstanceOf(PanTiltAttributes.class);
              PanTiltAttributes can = (PanTiltAttributes) each;
              assertThat(can.minPan()).isCloseTo(-3090 * POSITION, within(1e-12));
              assertThat(can.maxPan()).isCloseTo(3090 * POSITION, within(1e-12));
              assertThat(can.minTilt()).isCloseTo(-907 * POSITION, within(1e-12));
              assertThat(can.maxTilt()).isCloseTo(604 * POSITION, within(1e-12));
              assertThat(can.maxSpeed()).isCloseTo(2902 * POSITION, within(1e-12));
            });
    try (CommandLease lease = unit.command(Duration.ofSeconds(10))) {
      unit.obey(lease.key(), new Point(1000 * POSITION, -0.3, Math.toRadians(60)));
      // -0.3 rad are -334.2 positions; 60°/s are 1166.7 positions/s.
      assertThat(next()).isEqualTo("PS1167 TS1167 PP1000 TP-334 ");
      say("*\r\n*\r\n*\r\n*\r\n");
      poll(400, -334);
      assertThat(unit.panTilt().isMoving()).isTrue();
      poll(1000, -334);
      assertThat(unit.panTilt().isMoving()).isFalse();
      unit.obey(lease.key(), new Halt());
      assertThat(next()).isEqualTo("H ");
      say("*\r\n");
      unit.obey(lease.key(), new Point(0, 0, 1000));
      assertThat(next()).as("no faster than it can").isEqualTo("PS2902 TS2902 PP0 TP0 ");
      say("*\r\n*\r\n*\r\n*\r\n");
      unit.obey(lease.key(), new Point(0, 0, 1e-9));
      assertThat(next()).as("no slower than it can").isEqualTo("PS31 TS31 PP0 TP0 ");
      say("*\r\n*\r\n*\r\n*\r\n");
    }
    assertThat(next()).as("without a commander it halts").isEqualTo("H ");
  }

  @Test
  void refusesADirectionBeyondTheLimitsByBothSides() throws Exception {
    beReady();
    try (CommandLease lease = unit.command(Duration.ofSeconds(10))) {
      assertThatThrownBy(() -> unit.obey(lease.key(), new Point(3, 0, 1)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage(
              "atrv1/pan_tilt cannot point there: pan of 3.0000 rad is above the limit of 2.7736"
                  + " rad; ask for -2.7736 to 2.7736 rad");
      assertThatThrownBy(() -> unit.obey(lease.key(), new Point(0, -1, 1)))
          .hasMessageEndingWith(
              "tilt of -1.0000 rad is below the limit of -0.8141 rad; ask for -0.8141 to 0.5421"
                  + " rad");
      unit.obey(lease.key(), new Point(3090 * POSITION + 1e-9, 604 * POSITION, 1));
      assertThat(next()).as("nothing was sent before").endsWith("PP3090 TP604 ");
    }
  }

  @Test
  void noticesThatAReplyWasLostAndTakesNoNumberForAnother() {
    beReady();
    step(100);
    assertThat(next()).isEqualTo("PP ");
    step(1001); // and it is never answered
    awaitWords();
    setUp();
    poll(7, 8);
    assertThat(unit.panTilt().tilt()).isCloseTo(8 * POSITION, within(1e-12));
    assertThat(unit.readiness()).isEqualTo(Readiness.READY);
    awaitWords();
    assertThat(next()).isEqualTo("PP ");
    say("*\r\n"); // a reply to something else
    awaitWords();
    setUp();
    poll(9, 10);
    assertThat(unit.panTilt().pan()).isCloseTo(9 * POSITION, within(1e-12));
    assertThat(unit.history().failures()).isZero();
  }

  @Test
  void asksAgainWhenTheUnitTellsWhatCannotBe() {
    answers.put("PX", "-4000");
    awaitWords();
    setUp();
    awaitWords();
    answers.put("PX", "3090");
    answers.put("TR", "many");
    setUp();
    awaitWords();
    answers.put("TR", "185.1428");
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void failsWhenAnAxisRanAgainstItsEndUntilItIsReset() throws Exception {
    beReady();
    say("!T\r\n* 1\r\n");
    awaitReadiness(Readiness.FAILED);
    assertThatThrownBy(unit::panTilt)
        .hasMessageContaining("the tilt axis ran against its end")
        .hasMessageContaining("reset_by_moving");
    awaitWords();
    setUp();
    poll(1, 1);
    assertThat(unit.readiness()).as("it counts wrong").isEqualTo(Readiness.FAILED);
    CompletableFuture<Diagnosis> recovery =
        CompletableFuture.supplyAsync(() -> unit.recover("reset_by_moving"));
    awaitWords();
    String sent = next();
    while (!sent.equals("R ")) {
      say("* 0\r\n");
      awaitWords();
      sent = next();
    }
    awaitReadiness(Readiness.INITIALIZING);
    say("*\r\n");
    assertThat(recovery.join().passed()).isTrue();
    awaitWords();
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void comesBackWithALinkAndForgetsWhatItWasTold() {
    beReady();
    ScriptedLink second = links.add();
    link.unplug();
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(unit::panTilt).hasMessageContaining("the device is lost");
    link = second;
    heard = 0;
    await()
        .until(
            () -> {
              ticker.step(Duration.ofMillis(100)); // until the link is opened again
              return second.reads() > 0;
            });
    awaitWords();
    setUp();
    poll(5, 5);
    awaitReadiness(Readiness.READY);
    assertThat(unit.history().failures()).isEqualTo(1);
  }

  @Test
  void reopensALinkWhereNoUnitAnswers() {
    beReady();
    await()
        .untilAsserted(
            () -> {
              say("noise\r\n");
              ticker.step(Duration.ofMillis(500));
              assertThatThrownBy(unit::panTilt).hasMessageEndingWith("no position for 3 s");
            });
    awaitReadiness(Readiness.INITIALIZING);
  }

  @Test
  void countsRefusals() throws Exception {
    beReady();
    try (CommandLease lease = unit.command(Duration.ofSeconds(10))) {
      unit.obey(lease.key(), new Point(0.1, 0, 1));
      next();
      say("*\r\n*\r\n! Maximum allowable Pan position is 3090\r\n*\r\n");
      await().until(() -> parameter(unit, "refusals").equals("1"));
    }
  }

  @Test
  void haltsPastAWriteThatHangsAndOnceMoreAfterIt() throws Exception {
    beReady();
    CommandLease lease = unit.command(Duration.ofSeconds(10));
    CountDownLatch release = new CountDownLatch(1);
    link.holdUpAWrite(release);
    CompletableFuture<Void> writing =
        CompletableFuture.runAsync(
            () -> unit.obey(lease.key(), new Point(0.1, 0, 1)), run -> new Thread(run).start());
    try {
      await().until(() -> written().stream().anyMatch(each -> each.startsWith("PS")));
      assertThat(unit.emergencyStop("ops").latched()).isTrue();
      await().until(() -> written().contains("H "));
      assertThat(writing).isNotDone();
      settle(); // the reader does not wait for the write either
    } finally {
      release.countDown();
    }
    writing.get(60, TimeUnit.SECONDS);
    await().until(() -> written().stream().filter("H "::equals).count() == 2);
  }

  @Test
  void haltsPastAQuestionThatHangsAndOnceMoreAfterIt() throws Exception {
    beReady();
    CommandLease lease = unit.command(Duration.ofSeconds(10));
    unit.obey(lease.key(), new Point(0.1, 0, 1));
    assertThat(next()).startsWith("PS");
    say("*\r\n*\r\n*\r\n*\r\n");
    CountDownLatch release = new CountDownLatch(1);
    link.holdUpTheReader(release);
    try {
      ticker.step(Duration.ofMillis(200));
      assertThat(next()).isEqualTo("PP ");
      assertThat(unit.emergencyStop("ops").latched()).isTrue();
      assertThat(next()).as("while the question hangs").isEqualTo("H ");
      await().until(() -> unit.stopState().resting());
    } finally {
      release.countDown();
    }
    assertThat(next()).as("after it").isEqualTo("H ");
    say("*\r\n"); // the first halt was faster than the question
    awaitWords();
    setUp();
    poll(1, 1);
    awaitReadiness(Readiness.READY);
  }

  private List<String> written() {
    return link.written().stream()
        .map(each -> new String(each, StandardCharsets.US_ASCII))
        .toList();
  }

  @Test
  void doesNotResetUnderItsCommander() throws Exception {
    beReady();
    try (CommandLease unused = unit.command(Duration.ofSeconds(10))) {
      assertThat(unit.recover("reset_by_moving").finding())
          .isEqualTo(
              "it moves the head, which a module in its own virtual machine commands; have its"
                  + " lease closed first");
    }
  }

  @Test
  void doesNotResetWhileItIsStoppedForAnEmergency() {
    beReady();
    assertThat(unit.emergencyStop("ops").latched()).isTrue();
    assertThat(unit.recover("reset_by_moving").finding())
        .isEqualTo("it moves the head, which is stopped for an emergency; have it released first");
  }

  @Test
  void refusesParametersThatAreNone() {
    assertThatThrownBy(() -> driver(Map.of("link", URL, "rate", "50")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("parameter rate is \"50\", which is not a number from 0.5 to 20");
    assertThatThrownBy(() -> driver(Map.of())).hasMessageContaining("parameter link is not set");
    beReady();
    assertThatThrownBy(() -> unit.setParameter("rate", "fast"))
        .hasMessageContaining("a number from 0.5 to 20 Hz");
    unit.setParameter("rate", "5");
    assertThat(parameter(unit, "rate")).isEqualTo("5");
  }

  private void beReady() {
    awaitWords();
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  /** Lets time pass, each step looked at by the driver, until it says something. */
  private void awaitWords() {
    while (link.written().size() <= heard) {
      step(20);
    }
  }

  private void step(int millis) {
    ticker.step(Duration.ofMillis(millis));
    settle();
  }

  /** Waits until the driver has looked at all that was said, and at the time. */
  private void settle() {
    link.awaitLooked();
  }

  /** Is the unit until everything is told that is asked first, or something is told wrong. */
  private void setUp() {
    for (String setting : List.of("ED ", "FT ", "I ")) {
      assertThat(next()).isEqualTo(setting);
      say("*\r\n");
    }
    for (String question : QUESTIONS) {
      assertThat(next()).isEqualTo(question + " ");
      say("* " + answers.get(question) + "\r\n");
      if (answers.get(question).equals("many")) {
        return;
      }
    }
  }

  private void poll(int pan, int tilt) {
    awaitWords();
    assertThat(next()).isEqualTo("PP ");
    say("* " + pan + "\r\n");
    assertThat(next()).isEqualTo("TP ");
    say("* " + tilt + "\r\n");
    settle();
  }

  private String next() {
    await().pollInterval(Duration.ofMillis(1)).until(() -> link.written().size() > heard);
    return new String(link.written().get(heard++), StandardCharsets.US_ASCII);
  }

  private void say(String text) {
    link.say(text.getBytes(StandardCharsets.US_ASCII));
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(unit, expected);
  }

  private PtuImpl driver(Map<String, String> texts) {
    return new PtuImpl(context("pan_tilt", texts, () -> NOW), ticker, links);
  }
}
