package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nobody waits for a name server beyond the deadline. Look-ups wait until the test runs them. */
class PeerNamesTest {

  private static final String NAME = "field-robot";
  private static final String CALL = "Listener.notify";

  private final Deque<Runnable> lookUps = new ArrayDeque<>();
  private final AtomicInteger asked = new AtomicInteger();
  private long now;
  private String stands = "127.1.2.3";

  private final PeerNames names = new PeerNames(this::resolve, () -> now, lookUps::add);

  private InetAddress resolve(String name) throws UnknownHostException {
    asked.incrementAndGet();
    if (stands.isEmpty()) {
      throw new UnknownHostException(name);
    }
    return InetAddress.getByName(stands);
  }

  private String address(String name) throws Exception {
    return names.address(name, 1, CALL).getHostAddress();
  }

  private void awaitsInVain(String name) {
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> address(name))
        .withMessageContaining("got no answer within 1 ms; it has not run");
  }

  @Test
  void aLookUpIsAwaitedUntilTheDeadlineAndSharedByAllThatAsk() throws Exception {
    awaitsInVain(NAME);
    awaitsInVain(NAME);
    assertThat(lookUps).hasSize(1);
    assertThat(asked).as("on the thread that asked").hasValue(0);
    lookUps.remove().run();
    assertThat(address(NAME)).isEqualTo("127.1.2.3");
    assertThat(asked).hasValue(1);
    assertThat(lookUps).isEmpty();
  }

  @Test
  void whatIsKnownCountsUntilAnotherAnswerComes() throws Exception {
    awaitsInVain(NAME);
    lookUps.remove().run();
    now += PeerNames.KNOWN_FOR.toNanos();
    stands = "";
    assertThat(address(NAME)).isEqualTo("127.1.2.3");
    lookUps.remove().run();
    assertThat(address(NAME)).as("the name server is away").isEqualTo("127.1.2.3");
    stands = "127.1.2.4";
    lookUps.remove().run();
    assertThat(address(NAME)).as("the peer has another address").isEqualTo("127.1.2.4");
    assertThat(lookUps).isEmpty();
  }

  @Test
  void moreThanSoManyNamesAreRefusedAtOnceButNoneThatIsKnown() throws Exception {
    awaitsInVain(NAME);
    lookUps.remove().run();
    for (int i = 0; i < PeerNames.AT_ONCE; i++) {
      awaitsInVain("slow-" + i);
    }
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> address("another"))
        .withMessageContaining(CALL + " was not tried");
    now += PeerNames.KNOWN_FOR.toNanos();
    assertThat(address(NAME)).isEqualTo("127.1.2.3");
    assertThat(lookUps).hasSize(PeerNames.AT_ONCE);
    lookUps.remove().run();
    awaitsInVain("another");
    assertThat(lookUps).as("there is room again").hasSize(PeerNames.AT_ONCE);
  }

  @Test
  void aNameThatIsNotKnownIsReportedAndLookedUpAgain() throws Exception {
    stands = "";
    PeerNames atOnce = new PeerNames(this::resolve, () -> now, Runnable::run);
    assertThatExceptionOfType(java.rmi.UnknownHostException.class)
        .isThrownBy(() -> atOnce.address(NAME, 1, CALL))
        .withMessageContaining("the host of " + CALL + " is not known");
    stands = "127.1.2.3";
    assertThat(atOnce.address(NAME, 1, CALL).getHostAddress()).isEqualTo("127.1.2.3");
  }

  @ParameterizedTest
  @ValueSource(strings = {"127.1.2.3", "::1", "fd00::7"})
  void anAddressInDigitsIsNoName(String host) {
    assertThat(PeerNames.isName(host)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {NAME, "localhost", "10.0.0", "10.0.0.256", ""})
  void anythingElseIsOne(String host) {
    assertThat(PeerNames.isName(host)).isTrue();
  }
}
