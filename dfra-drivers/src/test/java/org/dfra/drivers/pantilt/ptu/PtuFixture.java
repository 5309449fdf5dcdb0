package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.context;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A driver of a pan-tilt unit alone: the test is the unit and the time. */
@Timeout(120)
abstract class PtuFixture {

  static final String URL = "tcp://unit:4001";
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
  static final double POSITION = Math.toRadians(185.1428 / 3600);

  /** What a PTU-46-17.5 says. */
  static final Map<String, String> ANSWERS =
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

  static final List<String> QUESTIONS =
      List.of("PR", "TR", "PN", "PX", "TN", "TX", "PL", "PU", "TL", "TU");

  final StepTicker ticker = new StepTicker(false);
  final ScriptedLinks links = new ScriptedLinks(URL);
  final Map<String, String> answers = new HashMap<>(ANSWERS);
  ScriptedLink link = new ScriptedLink(URL);
  int received; // pieces that the driver wrote
  final PtuImpl unit = driver(Map.of("link", URL, "mount_x", "0.2"));

  @BeforeEach
  void start() {
    links.add(link);
    unit.start();
  }

  @AfterEach
  void end() {
    unit.close();
  }

  void beReady() {
    awaitWords();
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  /** Lets time pass, each step looked at by the driver, until it says something. */
  void awaitWords() {
    while (link.written().size() <= received) {
      step(20);
    }
  }

  void step(int millis) {
    ticker.step(Duration.ofMillis(millis));
    settle();
  }

  /** Waits until the driver has looked at all that was said, and at the time. */
  void settle() {
    link.awaitLooked();
  }

  /** Is the unit until everything is answered that is asked first, or an answer is wrong. */
  void setUp() {
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

  void poll(int pan, int tilt) {
    awaitWords();
    assertThat(next()).isEqualTo("PP ");
    say("* " + pan + "\r\n");
    assertThat(next()).isEqualTo("TP ");
    say("* " + tilt + "\r\n");
    settle();
  }

  String next() {
    await().pollInterval(Duration.ofMillis(1)).until(() -> link.written().size() > received);
    return new String(link.written().get(received++), StandardCharsets.US_ASCII);
  }

  void say(String text) {
    link.say(text.getBytes(StandardCharsets.US_ASCII));
  }

  void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(unit, expected);
  }

  PtuImpl driver(Map<String, String> texts) {
    return new PtuImpl(context("pan_tilt", texts, () -> NOW), ticker, links);
  }
}
