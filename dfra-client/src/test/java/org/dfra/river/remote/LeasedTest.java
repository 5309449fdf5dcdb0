package org.dfra.river.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.List;
import net.jini.core.lease.Lease;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a server gives lasts as long as it was granted, however the clock is set. */
class LeasedTest {

  private static final List<Long> NUMBERS = Collections.nCopies(EventKind.values().length, 0L);

  private Instant wall = Instant.parse("2026-11-23T00:00:00Z");
  private long nanos = Long.MAX_VALUE - 5_000_000_000L; // overflows soon
  private long expiration = wall.plusSeconds(10).toEpochMilli();
  private final Lease lease = lease((self, method, arguments) -> expiration);

  private static Lease lease(InvocationHandler answers) {
    return (Lease)
        Proxy.newProxyInstance(
            LeasedTest.class.getClassLoader(), new Class<?>[] {Lease.class}, answers);
  }

  private static Lease serializable(long end) {
    return lease((InvocationHandler & Serializable) (self, method, arguments) -> end);
  }

  private void pass(Duration time) {
    wall = wall.plus(time);
    nanos += time.toNanos();
  }

  @ParameterizedTest
  @ValueSource(longs = {3600, -3600})
  void aClockThatIsSetNeitherEndsNorProlongsThem(long step) {
    GrantedModuleLease use = new GrantedModuleLease(lease, () -> wall, () -> nanos);
    GrantedSubscription subscription =
        new GrantedSubscription(lease, 1, NUMBERS, () -> wall, () -> nanos);
    wall = wall.plusSeconds(step);
    pass(Duration.ofMillis(9_999));
    assertThat(use.isLive()).isTrue();
    assertThat(subscription.isOpen()).isTrue();
    pass(Duration.ofMillis(1));
    assertThat(use.isLive()).isFalse();
    assertThat(subscription.isOpen()).isFalse();
  }

  @Test
  void oneThatSomebodyHasRenewedLastsAsLongAgain() {
    GrantedModuleLease use = new GrantedModuleLease(lease, () -> wall, () -> nanos);
    pass(Duration.ofSeconds(9));
    expiration = wall.plusSeconds(10).toEpochMilli();
    assertThat(use.isLive()).isTrue();
    pass(Duration.ofSeconds(9));
    assertThat(use.isLive()).isTrue();
    pass(Duration.ofSeconds(1));
    assertThat(use.isLive()).isFalse();
  }

  @Test
  void oneThatWasGrantedForEverIsLive() {
    expiration = Lease.FOREVER;
    assertThat(new GrantedModuleLease(lease, () -> wall, () -> nanos).isLive()).isTrue();
  }

  @Test
  void whatArrivesCountsFromItsArrival() throws Exception {
    Lease given = serializable(System.currentTimeMillis() + 600_000);
    assertThat(arrived(new GrantedModuleLease(given)).isLive()).isTrue();
    GrantedSubscription subscription = arrived(new GrantedSubscription(given, 7, NUMBERS));
    assertThat(subscription.isOpen()).isTrue();
    assertThat(subscription.epoch()).isEqualTo(7);
    assertThat(subscription.sequenceNumbers()).isEqualTo(NUMBERS);
    assertThat(arrived(new GrantedModuleLease(serializable(0))).isLive()).isFalse();
    assertThatThrownBy(() -> new GrantedModuleLease(null)).isInstanceOf(NullPointerException.class);
  }

  @SuppressWarnings("unchecked")
  private static <T> T arrived(T sent) throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(sent);
    }
    return (T) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
  }
}
