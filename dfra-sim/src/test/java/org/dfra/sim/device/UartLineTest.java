package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
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
    line.take(small, BEGIN.plusSeconds(1));
    assertThat(small.array()).containsExactly(1, 2);
    small.clear();
    line.take(small, BEGIN.plusSeconds(1));
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
  void refusesSpeedsNoLineHas() {
    assertThatThrownBy(() -> new UartLine(0)).hasMessage("baud rate 0 is outside 1 to 4000000");
  }

  private static int through(UartLine line, Instant now) {
    ByteBuffer out = ByteBuffer.allocate(4096);
    line.take(out, now);
    return out.position();
  }
}
