package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class UartLineTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:00:00Z");

  @Test
  void lets960BytesThroughInASecondAt9600Baud() {
    UartLine line = new UartLine(9600);
    line.send(new byte[2000], BEGIN);
    assertThat(through(line, BEGIN.plusSeconds(1))).isEqualTo(960);
    assertThat(through(line, BEGIN.plusSeconds(2))).isEqualTo(960);
    assertThat(through(line, BEGIN.plusSeconds(3))).isEqualTo(80);
    assertThat(line.waitingBytes()).isZero();
  }

  @Test
  void losesNoTimeHoweverOftenItIsAsked() {
    UartLine line = new UartLine(9600);
    line.send(new byte[2000], BEGIN);
    int total = 0;
    for (int i = 1; i <= 1000; i++) {
      total += through(line, BEGIN.plusNanos(i * 1_000_000L));
      assertThat(total).isEqualTo(i * 960 / 1000);
    }
  }

  @Test
  void aByteIsThroughWithItsLastBit() {
    UartLine line = new UartLine(1000); // 10 ms a byte
    line.send(new byte[2], BEGIN);
    assertThat(through(line, BEGIN.plusNanos(9_999_999))).isZero();
    assertThat(through(line, BEGIN.plusNanos(10_000_000))).isOne();
  }

  @Test
  void savesNoTimeWhileItIsIdle() {
    UartLine line = new UartLine(1000);
    through(line, BEGIN);
    line.send(new byte[100], BEGIN.plusSeconds(60));
    assertThat(through(line, BEGIN.plusSeconds(60))).isZero();
    assertThat(through(line, BEGIN.plusSeconds(60).plusMillis(50))).isEqualTo(5);
  }

  @Test
  void keepsWhatDoesNotFit() {
    UartLine line = new UartLine(9600);
    line.send(new byte[] {1, 2, 3}, BEGIN);
    ByteBuffer small = ByteBuffer.allocate(2);
    line.drainTo(small, BEGIN.plusSeconds(1));
    assertThat(small.array()).containsExactly(1, 2);
    small.clear();
    line.drainTo(small, BEGIN.plusSeconds(1));
    assertThat(small.flip().get()).isEqualTo((byte) 3);
  }

  @Test
  void goesOnAfterTheClockWasSetBack() {
    UartLine line = new UartLine(9600);
    line.send(new byte[2000], BEGIN);
    Instant earlier = BEGIN.minus(Duration.ofHours(1));
    assertThat(through(line, earlier)).isZero();
    assertThat(through(line, earlier.plusSeconds(1))).isEqualTo(960);
  }

  @Test
  void goesOnAfterTheClockOfAnIdleLineWasSetBack() {
    UartLine line = new UartLine(9600);
    line.send(new byte[960], BEGIN);
    assertThat(through(line, BEGIN.plusSeconds(10))).isEqualTo(960);
    Instant earlier = BEGIN.minus(Duration.ofHours(1));
    line.send(new byte[960], earlier);
    assertThat(through(line, earlier.plusMillis(500))).isEqualTo(480);
  }

  @Test
  void whatIsOnItsWayKeepsItsSpeedWhenTheLineGetsAnother() {
    UartLine line = new UartLine(1000); // 10 ms a byte
    line.send(new byte[] {1, 2, 3}, BEGIN);
    line.setBaud(10_000); // 1 ms a byte
    line.send(new byte[] {4, 5}, BEGIN);
    assertThat(line.baud()).isEqualTo(10_000);
    assertThat(bytes(line, BEGIN.plusMillis(29))).containsExactly(1, 2);
    assertThat(bytes(line, BEGIN.plusMillis(30))).containsExactly(3);
    assertThat(bytes(line, BEGIN.plusMillis(31))).containsExactly(4);
    line.setBaud(100);
    assertThat(bytes(line, BEGIN.plusMillis(32))).containsExactly(5);
    line.send(new byte[] {6}, BEGIN.plusMillis(40));
    assertThat(bytes(line, BEGIN.plusMillis(139))).isEmpty();
    assertThat(bytes(line, BEGIN.plusMillis(140))).containsExactly(6);
  }

  @Test
  void aByteHalfwayOutKeepsItsSpeed() {
    UartLine line = new UartLine(1000);
    line.send(new byte[1], BEGIN);
    assertThat(through(line, BEGIN.plusMillis(5))).isZero();
    line.setBaud(4_000_000);
    assertThat(through(line, BEGIN.plusMillis(9))).isZero();
    assertThat(through(line, BEGIN.plusMillis(10))).isOne();
  }

  @Test
  void refusesSpeedsNoLineHas() {
    UartLine line = new UartLine(9600);
    assertThatThrownBy(() -> line.setBaud(4_000_001))
        .hasMessage("baud rate 4000001 is outside 1 to 4000000");
    assertThat(line.baud()).isEqualTo(9600);
    assertThatThrownBy(() -> new UartLine(0)).hasMessage("baud rate 0 is outside 1 to 4000000");
  }

  private static byte[] bytes(UartLine line, Instant now) {
    ByteBuffer out = ByteBuffer.allocate(4096);
    line.drainTo(out, now);
    return Arrays.copyOf(out.array(), out.position());
  }

  private static int through(UartLine line, Instant now) {
    ByteBuffer out = ByteBuffer.allocate(4096);
    line.drainTo(out, now);
    return out.position();
  }
}
