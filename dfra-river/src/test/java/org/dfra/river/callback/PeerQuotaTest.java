package org.dfra.river.callback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.dfra.river.callback.PeerQuota.QuotaLimits;
import org.junit.jupiter.api.Test;

/** What one client holds leaves room for the others. */
class PeerQuotaTest {

  private static final ClientAddress OWN = ClientAddress.of("127.0.0.1", "127.8.8.8");
  private static final ClientAddress FIRST = ClientAddress.of("127.1.1.66", "127.8.8.8");
  private static final ClientAddress SECOND = ClientAddress.of("127.1.1.67", "127.8.8.8");
  private static final ClientAddress THIRD = ClientAddress.of("127.1.1.68", "127.8.8.8");

  private final PeerQuota quota = new PeerQuota("listeners of atrv1/gps", new QuotaLimits(2, 3, 4));

  private void take(ClientAddress client, int count) {
    for (int i = 0; i < count; i++) {
      assertThat(quota.acquire(client)).as("refusal %d of %s", i, client).isEmpty();
    }
  }

  @Test
  void oneAddressHasItsShareOnly() {
    take(FIRST, 2);
    assertThat(quota.acquire(FIRST))
        .contains(
            "listeners of atrv1/gps: 127.1.1.66 holds 2 of at most 2; close some of them first,"
                + " or wait until their leases end");
    take(SECOND, 1);
    quota.release(FIRST);
    take(FIRST, 1);
  }

  @Test
  void otherComputersTogetherCannotUseUpWhatThisOneHas() {
    take(FIRST, 2);
    take(SECOND, 1);
    assertThat(quota.acquire(THIRD))
        .get()
        .asString()
        .contains("other computers hold 3 of at most 3");
    take(OWN, 4);
    assertThat(quota.acquire(OWN)).get().asString().contains("this computer holds 4 of at most 4");
    assertThat(quota.held()).isEqualTo(7);
    quota.release(SECOND);
    take(THIRD, 1);
    assertThat(quota.held()).isEqualTo(7);
  }

  @Test
  void thisComputerIsWhatAdministersIt() {
    assertThat(ClientAddress.of("127.8.8.8", "127.8.8.8").isLocal()).isTrue();
    assertThat(ClientAddress.of("127.0.0.1", "127.8.8.8").isLocal()).isTrue();
    assertThat(ClientAddress.of("0:0:0:0:0:0:0:1", "127.8.8.8").isLocal()).isTrue();
    assertThat(ClientAddress.of("127.8.8.9", "127.8.8.8").isLocal()).isFalse();
    assertThat(ClientAddress.of("127.0.0.2", "192.0.2.1").isLocal())
        .as("nobody else calls from the loopback of a robot that others reach")
        .isTrue();
    assertThat(ClientAddress.of("203.0.113.77", "192.0.2.1").isLocal()).isFalse();
    assertThat(ClientAddress.ofCurrentCall("192.0.2.1").isLocal()).as("no remote call").isTrue();
  }

  @Test
  void anAddressThatIsNotKnownIsNotThisComputers() {
    assertThat(ClientAddress.of("localhost", "127.8.8.8"))
        .as("names are not looked up")
        .isEqualTo(new ClientAddress("an unknown address", false));
    assertThat(ClientAddress.of("127.0.0.1", "[no host").isLocal())
        .as("nobody else calls from there, whatever the server's name stands for")
        .isTrue();
    assertThat(ClientAddress.of("127.0.0.2", "[no host").isLocal()).isFalse();
  }

  @Test
  void limitsThatCannotBeKeptAreRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new QuotaLimits(5, 3, 4))
        .withMessage("limits must be 1 <= perAddress 5 <= others 3, and 1 <= own 4");
  }
}
