package org.dfra.sim.device.pantilt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The unit alone, stepped; commands and replies are the examples of its manual, section 4. */
class PtuDeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T10:00:00Z");
  private static final double POSITION = Math.toRadians(185.1428 / 3600);

  private record Pointed(Instant time, double pan, double tilt) {}

  private final List<Pointed> pointed = new ArrayList<>();
  private final PtuDevice unit = unit(115_200, false);
  private Instant now = BEGIN;

  private PtuDevice unit(int baud, boolean resets) {
    return new PtuDevice(
        (time, pan, tilt) -> pointed.add(new Pointed(time, pan, tilt)), baud, resets);
  }

  @Test
  void echoesAndAnswersInSentencesUntilBothAreDisabled() {
    say("");
    assertThat(say("PP ")).isEqualTo("PP * Current Pan position is 0\r\n");
    assertThat(say("ED ")).isEqualTo("ED *\r\n");
    assertThat(say("PP\r")).isEqualTo("* Current Pan position is 0\r\n");
    assertThat(say("FT ")).isEqualTo("*\r\n");
    assertThat(say("pp ")).isEqualTo("* 0\r\n");
    assertThat(say("PR TR ")).isEqualTo("* 185.1428\r\n* 185.1428\r\n");
    assertThat(say("FV PR ")).isEqualTo("*\r\n* 185.1428 seconds arc per Pan position\r\n");
    assertThat(say("EE PN ")).isEqualTo("*\r\nPN * Minimum Pan position is -3090\r\n");
  }

  @Test
  void reportsItsLimitsAndRefusesWhatIsBeyondThem() {
    begin();
    assertThat(say("PN PX TN TX ")).isEqualTo("* -3090\r\n* 3090\r\n* -907\r\n* 604\r\n");
    assertThat(say("PP3200 ")).isEqualTo("! Maximum allowable Pan position is 3090\r\n");
    assertThat(say("TP-908 ")).isEqualTo("! Minimum allowable Tilt position is -907\r\n");
    assertThat(say("PS3300 ")).isEqualTo("! Pan speed cannot exceed 2902 positions/sec\r\n");
    assertThat(say("PS20 ")).isEqualTo("! Motor speed cannot be less than 31 pos/sec\r\n");
    assertThat(say("XY PPP PP99999999 PN5 "))
        .isEqualTo(
            "! Illegal command\r\n! Illegal command\r\n! Illegal command\r\n"
                + "! Illegal command argument\r\n");
  }

  @Test
  void rampsUpAndDownAndTakesAsLongAsPhysicsSays() {
    begin();
    assertThat(say("PS1000 PP2000 ")).isEqualTo("*\r\n*\r\n");
    Instant began = now;
    Duration took = waitUntil("PP ", "* 2000\r\n", began);
    // From a base speed of 57/s by 2000/s² to 1000/s takes 0.4715 s and 249 positions, and as long
    // down again; the 1502 left take 1.502 s: 2.445 s. It is asked every 10 ms.
    assertThat(took.toMillis() / 1e3).isCloseTo(2.445, within(0.05));
    assertThat(pointed.get(pointed.size() - 1).pan()).isCloseTo(2000 * POSITION, within(1e-9));
    for (int i = 1; i < pointed.size(); i++) {
      Pointed before = pointed.get(i - 1);
      Pointed after = pointed.get(i);
      Duration step = Duration.between(before.time(), after.time());
      assertThat(after.pan()).isGreaterThan(before.pan());
      if (i > 1) {
        assertThat(step).isLessThanOrEqualTo(Duration.ofMillis(10));
        assertThat((after.pan() - before.pan()) / (step.toNanos() / 1e9))
            .isLessThanOrEqualTo(1000 * POSITION * 1.001);
      }
    }
  }

  @Test
  void doesNotDependOnHowOftenItIsLookedAt() {
    begin();
    String command = "PS700 TS300 PP-1234 TP400 ";
    say(command);
    run(Duration.ofMillis(900), Duration.ofMillis(900));
    double often = pointed.get(pointed.size() - 1).pan();
    PtuDevice other = unit(115_200, false);
    List<Pointed> before = List.copyOf(pointed);
    now = BEGIN;
    exchange(other, "");
    exchange(other, "ED FT ");
    exchange(other, command);
    for (int i = 0; i < 910; i++) { // say has let 10 ms pass
      now = now.plusMillis(1);
      exchange(other, "");
    }
    assertThat(pointed.size()).isGreaterThan(before.size());
    assertThat(pointed.get(pointed.size() - 1).pan()).isCloseTo(often, within(1e-12));
  }

  @Test
  void haltsWhereItIsButForTheRamp() {
    begin();
    say("PS2000 PP3000 ");
    run(Duration.ofMillis(1200), Duration.ofMillis(10));
    int at = position();
    say("H ");
    run(Duration.ofSeconds(3), Duration.ofMillis(10));
    int stood = position();
    // 2000/s is stopped by 2000/s² within 1000 positions; 10 ms passed before the command.
    assertThat(stood - at).isBetween(900, 1030);
    run(Duration.ofSeconds(1), Duration.ofMillis(10));
    assertThat(position()).isEqualTo(stood);
  }

  @Test
  void turnsAroundOnTheWay() {
    begin();
    say("PS1500 PP3000 ");
    run(Duration.ofMillis(1000), Duration.ofMillis(10));
    say("PP-500 ");
    run(Duration.ofSeconds(6), Duration.ofMillis(10));
    assertThat(position()).isEqualTo(-500);
  }

  @Test
  void goesToBothEndsWhenItIsResetAndAnswersThen() {
    begin();
    say("PP500 ");
    run(Duration.ofSeconds(2), Duration.ofMillis(10));
    pointed.clear();
    assertThat(say("R PP ")).isEmpty();
    String output = run(Duration.ofSeconds(30), Duration.ofMillis(10));
    assertThat(output).isEqualTo("*\r\n* 0\r\n");
    assertThat(pointed).anyMatch(p -> p.pan() <= -3090 * POSITION + 1e-9);
    assertThat(pointed).anyMatch(p -> p.pan() >= 3090 * POSITION - 1e-9);
    assertThat(pointed).anyMatch(p -> p.tilt() <= -907 * POSITION + 1e-9);
    assertThat(pointed).anyMatch(p -> p.tilt() >= 604 * POSITION - 1e-9);
  }

  @Test
  void takesItsTimeWhenItIsSwitchedOn() {
    PtuDevice cold = unit(9600, true);
    String output = exchange(cold, "");
    for (int i = 0; i < 30; i++) {
      now = now.plusMillis(100);
      output += exchange(cold, "");
    }
    assertThat(output).startsWith("\r\n### PAN-TILT CONTROLLER").endsWith("Initializing...\r\n");
    output = exchange(cold, "ED ");
    for (int i = 0; i < 300; i++) {
      now = now.plusMillis(100);
      output += exchange(cold, "");
    }
    assertThat(output).isEqualTo("*\r\nED *\r\n");
  }

  @Test
  void waitsForTheEndOfAMotion() {
    begin();
    assertThat(say("S PP1000 ")).isEqualTo("*\r\n*\r\n");
    run(Duration.ofSeconds(1), Duration.ofMillis(10));
    assertThat(position()).as("nothing has begun").isZero();
    assertThat(say("A PP ")).isEmpty();
    assertThat(run(Duration.ofSeconds(3), Duration.ofMillis(10))).isEqualTo("*\r\n* 1000\r\n");
  }

  @Test
  void reportsWhenAnAxisReachesItsEnd() {
    begin();
    assertThat(say("LD TP2000 ")).isEqualTo("*\r\n*\r\n");
    assertThat(run(Duration.ofSeconds(5), Duration.ofMillis(10))).isEqualTo("!T\r\n");
  }

  @Test
  void takesAsLongAsItsLineNeeds() {
    PtuDevice slow = unit(9600, false);
    run(slow, Duration.ofSeconds(1));
    exchange(slow, "ED FT ");
    run(slow, Duration.ofSeconds(1));
    exchange(slow, "PP "); // 5 bytes come back: 5.2 ms
    now = now.plusMillis(5);
    assertThat(exchange(slow, "")).isEqualTo("* 0\r");
    now = now.plusMillis(1);
    assertThat(exchange(slow, "")).isEqualTo("\n");
  }

  private void begin() {
    say("");
    say("ED FT ");
    pointed.clear();
  }

  private int position() {
    return Integer.parseInt(say("PP ").strip().substring(2));
  }

  /** Sends something and receives the whole answer; time passes as the line needs. */
  private String say(String text) {
    String output = exchange(unit, text);
    return output + run(Duration.ofMillis(10), Duration.ofMillis(10));
  }

  private String run(Duration length, Duration step) {
    StringBuilder output = new StringBuilder();
    for (Duration left = length; left.compareTo(Duration.ZERO) > 0; left = left.minus(step)) {
      now = now.plus(step);
      output.append(exchange(unit, ""));
    }
    return output.toString();
  }

  private void run(PtuDevice device, Duration length) {
    now = now.plus(length);
    exchange(device, "");
  }

  private Duration waitUntil(String question, String answer, Instant since) {
    for (int i = 0; i < 1000; i++) {
      if (say(question).equals(answer)) {
        return Duration.between(since, now);
      }
    }
    throw new AssertionError("it never answered " + answer);
  }

  private String exchange(PtuDevice device, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    device.receive(bytes, 0, bytes.length, now);
    ByteBuffer out = ByteBuffer.allocate(4096);
    device.transmit(out, now);
    return new String(out.array(), 0, out.position(), StandardCharsets.US_ASCII);
  }
}
