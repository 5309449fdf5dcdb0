package org.dfra.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Clock;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.concurrent.locks.Condition;
import org.junit.jupiter.api.Test;

class TickerTest {

  @Test
  void theComputersOwnClockIsReplacedByItsMonotonicTime() {
    assertThat(Ticker.of(InstantSource.system())).isSameAs(Ticker.system());
    assertThat(Ticker.of(Clock.systemUTC())).isSameAs(Ticker.system());
    assertThat(Ticker.of(Clock.system(ZoneId.of("Asia/Tokyo")))).isSameAs(Ticker.system());
  }

  @Test
  void aClockThatIsATickerIsTakenAsItIs() {
    Stopped stopped = new Stopped();
    assertThat(Ticker.of(stopped)).isSameAs(stopped);
  }

  private static final class Stopped implements InstantSource, Ticker {
    @Override
    public Instant instant() {
      return Instant.EPOCH;
    }

    @Override
    public long nanos() {
      return 0;
    }

    @Override
    public void await(Condition condition, long nanos) {
      throw new AssertionError("nobody waits here");
    }
  }

  @Test
  void anyOtherClockIsFollowed() {
    Clock stopped = Clock.fixed(Instant.ofEpochSecond(3, 5), ZoneOffset.UTC);
    assertThat(Ticker.of(stopped).nanos()).isEqualTo(3_000_000_005L);
  }
}
