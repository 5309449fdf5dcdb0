package org.dfra.river.callback;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.access.OwnAddresses;
import org.junit.jupiter.api.Test;

/** Nobody who asks waits for a name server. Look-ups wait until the test runs them. */
class AsyncHostResolverTest {

  private static final String NAME = "field-robot";

  private final Deque<Runnable> lookUps = new ArrayDeque<>();
  private final AtomicInteger asked = new AtomicInteger();
  private long now;
  private String stands = "127.1.2.3";

  private final AsyncHostResolver hosts =
      new AsyncHostResolver(this::resolve, () -> now, lookUps::add);

  private OwnAddresses resolve(String host) throws UnknownHostException {
    asked.incrementAndGet();
    if (stands.isEmpty()) {
      throw new UnknownHostException(host);
    }
    return OwnAddresses.exportedAt(stands);
  }

  private boolean isOwn(String address) throws UnknownHostException {
    InetAddress caller = InetAddress.getByName(address);
    return hosts.addressesOf(NAME).map(own -> own.contains(caller)).orElse(false);
  }

  private void runLookUp() {
    lookUps.remove().run();
  }

  @Test
  void answersAtOnceAndLooksUpElsewhere() throws Exception {
    assertThat(hosts.addressesOf(NAME)).as("nobody has looked it up yet").isEmpty();
    assertThat(hosts.addressesOf(NAME)).isEmpty();
    assertThat(asked).as("on the thread that asked").hasValue(0);
    assertThat(lookUps).as("one for all that ask").hasSize(1);
    runLookUp();
    assertThat(isOwn("127.1.2.3")).isTrue();
    assertThat(isOwn("127.1.2.4")).isFalse();
    assertThat(asked).hasValue(1);
    assertThat(lookUps).isEmpty();
  }

  @Test
  void keepsWhatItKnowsUntilAnotherAnswerComes() throws Exception {
    assertThat(isOwn("127.1.2.3")).isFalse();
    runLookUp();
    now += AsyncHostResolver.REFRESH_INTERVAL.toNanos();
    stands = "";
    assertThat(isOwn("127.1.2.3")).isTrue();
    runLookUp();
    assertThat(isOwn("127.1.2.3")).as("the name server is away").isTrue();
    assertThat(lookUps).as("looked up again later only").isEmpty();
    now += AsyncHostResolver.RETRY_INTERVAL.toNanos();
    stands = "127.1.2.4";
    assertThat(isOwn("127.1.2.3")).isTrue();
    runLookUp();
    assertThat(isOwn("127.1.2.3")).as("the computer has another address").isFalse();
    assertThat(isOwn("127.1.2.4")).isTrue();
  }

  @Test
  void looksUpANameThatWasNotKnownAgainAfterAWhile() throws Exception {
    stands = "";
    assertThat(isOwn("127.1.2.3")).isFalse();
    runLookUp();
    assertThat(isOwn("127.1.2.3")).isFalse();
    assertThat(lookUps).isEmpty();
    now += AsyncHostResolver.RETRY_INTERVAL.toNanos();
    stands = "127.1.2.3";
    assertThat(isOwn("127.1.2.3")).isFalse();
    runLookUp();
    assertThat(isOwn("127.1.2.3")).isTrue();
  }

  @Test
  void looksNoAddressInDigitsUp() {
    assertThat(hosts.addressesOf("127.1.2.3")).isPresent();
    assertThat(hosts.addressesOf("::1")).isPresent();
    assertThat(lookUps).isEmpty();
    assertThat(asked).hasValue(0);
  }
}
