package org.dfra.sim.device;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.Random;
import org.dfra.sim.device.Cable.BaudMismatch;
import org.dfra.sim.device.Cable.ByteCorrupter;
import org.junit.jupiter.api.Test;

class CableTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:00:00Z");

  private final EchoDevice device = new EchoDevice(1000); // 10 ms a byte
  private final Cable cable = new Cable(device);

  private void send(String text, int millis) {
    cable.send(text.getBytes(US_ASCII), BEGIN.plusMillis(millis));
  }

  private String passed(int millis) {
    return new String(cable.pass(BEGIN.plusMillis(millis)), US_ASCII);
  }

  @Test
  void pacesWhatTheComputerSays() {
    send("abc", 0);
    assertThat(passed(9)).isEmpty();
    assertThat(passed(20)).isEqualTo("ab");
    assertThat(device.last()).isEqualTo(BEGIN.plusMillis(20));
    assertThat(passed(30)).isEqualTo("c");
  }

  @Test
  void followsADeviceThatChangesItsSpeed() {
    send("ab", 0);
    device.setBaud(10_000); // 1 ms a byte
    send("cd", 0);
    assertThat(passed(20)).isEqualTo("ab");
    assertThat(passed(22)).isEqualTo("cd");
  }

  @Test
  void pacesNothingForADeviceOnNoLine() {
    device.setBaud(0);
    send("abc", 0);
    assertThat(device.got()).isEqualTo("abc");
    assertThat(passed(0)).isEqualTo("abc");
  }

  @Test
  void letsNothingThroughWhenItIsPulledAndForgetsWhatWasOnIt() {
    send("a", 0);
    cable.unplug();
    send("b", 1);
    assertThat(cable.isPulled()).isTrue();
    assertThat(passed(100)).isEmpty();
    cable.restore();
    assertThat(cable.isPulled()).isFalse();
    assertThat(passed(200)).isEmpty();
    send("c", 200);
    assertThat(passed(210)).isEqualTo("c");
    assertThat(device.got()).isEqualTo("c");
  }

  @Test
  void isSilentInBothDirectionsAndNotPulled() {
    send("a", 0);
    assertThat(passed(10)).isEqualTo("a");
    cable.mute();
    send("b", 10);
    assertThat(passed(20)).isEmpty();
    assertThat(cable.isPulled()).isFalse();
    cable.restore();
    send("c", 20);
    assertThat(passed(30)).isEqualTo("c");
    assertThat(device.got()).as("it is the cable that is silent").isEqualTo("ac");
  }

  @Test
  void garblesTheSameBytesInTheSameWayForTheSameSeed() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    device.setBaud(0);
    String text = "0123456789".repeat(100);
    cable.corruptBytes(seed, 0.05);
    send(text, 0);
    String first = passed(0);
    String there = device.got();
    assertThat(there).as("-Ddfra.seed=%d", seed).isNotEqualTo(text);
    assertThat(first).as("-Ddfra.seed=%d", seed).isNotEqualTo(there);
    cable.corruptBytes(seed, 0.05); // it starts again
    send(text, 0);
    assertThat(passed(0)).as("-Ddfra.seed=%d", seed).isEqualTo(first);
    assertThat(device.got()).as("-Ddfra.seed=%d", seed).isEqualTo(there + there);
    cable.restore();
    send(text, 0);
    assertThat(passed(0)).isEqualTo(text);
  }

  @Test
  void damagesTheShareThatIsConfigured() {
    byte[] bytes = new byte[100_000];
    int same = 0;
    for (byte each : new ByteCorrupter(1, 0.3).corrupt(bytes)) {
      same += each == 0 ? 1 : 0;
    }
    // 70 % pass; a third of the others passes behind a spike; binomial, so 6 sigma are 900
    assertThat(same).isBetween(79_000, 81_500);
    assertThat(new ByteCorrupter(1, 0).corrupt(bytes)).isEqualTo(bytes);
    assertThatThrownBy(() -> cable.corruptBytes(1, 1.5)).hasMessage("share 1.5 is outside 0 to 1");
    assertThatThrownBy(() -> cable.corruptBytes(1, Double.NaN))
        .hasMessage("share NaN is outside 0 to 1");
  }

  @Test
  void hasStormsComeBetweenWhatTheDeviceSaysAndDamagesNothing() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    device.setBaud(0);
    cable.injectNoiseBursts(seed);
    String first = "";
    for (int i = 0; i < 100; i++) {
      send("word", i);
      String passed = passed(i);
      assertThat(passed).as("-Ddfra.seed=%d", seed).endsWith("word");
      first += passed;
    }
    assertThat(device.got()).as("-Ddfra.seed=%d", seed).isEqualTo("word".repeat(100));
    assertThat(first.length()).as("bytes, -Ddfra.seed=%d", seed).isGreaterThan(10_000);
    assertThat(passed(100)).as("without words there is no storm").isEmpty();
    cable.injectNoiseBursts(seed); // it starts again
    for (int i = 100; i < 200; i++) {
      send("word", i);
      String passed = passed(i);
      assertThat(first).as("-Ddfra.seed=%d", seed).startsWith(passed);
      first = first.substring(passed.length());
    }
  }

  @Test
  void aReplacedDeviceKnowsNothingOfTheLast() {
    EchoDevice next = new EchoDevice(0);
    send("a", 0);
    cable.replace(next);
    assertThat(passed(10)).isEmpty();
    send("b", 10);
    assertThat(next.got()).isEqualTo("b");
    assertThat(device.got()).isEmpty();
  }

  @Test
  void understandsNothingAtTwoSpeeds() {
    device.setBaud(9600);
    cable.setPortBaud(38_400);
    send("status", 0);
    String read = passed(1000);
    assertThat(device.got()).isNotEqualTo("status");
    assertThat(read).isNotEqualTo(device.got());
    cable.setPortBaud(9600);
    String before = device.got();
    send("status", 1000);
    assertThat(passed(2000)).isEqualTo("status");
    assertThat(device.got()).isEqualTo(before + "status");
    cable.setPortBaud(0);
    device.setBaud(500_000);
    send("type", 2000);
    assertThat(passed(3000)).as("it follows").isEqualTo("type");
  }

  @Test
  void readsTheBitsOfTheWrongSpeedAsTheyAre() {
    byte[] some = {0x55, 0x55};
    assertThat(BaudMismatch.of(some, 9600, 9600)).isEqualTo(some);
    // a zero is low for nine bits, at half the speed four and a half: the start bit, and those that
    // are looked at after 1.5, 2.5 and 3.5; then idle
    assertThat(BaudMismatch.of(new byte[] {0}, 9600, 4800)).containsExactly(0xF8);
    // a zero at 4800 is low for eighteen bits at 9600: a zero with a false stop bit, no second
    // start
    assertThat(BaudMismatch.of(new byte[] {0}, 4800, 9600)).containsExactly(0);
    assertThat(BaudMismatch.of(new byte[] {}, 4800, 9600)).isEmpty();
  }
}
