package org.dfra.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.UnknownHostException;
import org.dfra.core.config.ConfigurationException;
import org.dfra.river.bootstrap.HostAddress;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HostAddressTest {

  @Test
  void autoIsAnIpv4AddressOfThisMachineAndTheLoopbackOnlyWhereThereIsNoOther() throws Exception {
    String chosen = HostAddress.resolve("auto");
    InetAddress address = InetAddress.getByName(chosen);
    assertThat(NetworkInterface.getByInetAddress(address)).as(chosen).isNotNull();
    assertThat(address.getAddress()).hasSize(4);
    boolean hasOther =
        NetworkInterface.networkInterfaces()
            .filter(HostAddressTest::isUp)
            .flatMap(NetworkInterface::inetAddresses)
            .filter(each -> each.getAddress().length == 4)
            .anyMatch(each -> !each.isLoopbackAddress() && !each.isLinkLocalAddress());
    assertThat(HostAddress.isLoopback(chosen)).as(chosen).isEqualTo(!hasOther);
  }

  private static boolean isUp(NetworkInterface each) {
    try {
      return each.isUp() && !each.isVirtual();
    } catch (java.net.SocketException e) {
      return false;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"127.0.0.1", "localhost", "127.0.0.2"})
  void theLoopbackIsTakenWhereItIsAskedFor(String host) {
    assertThat(HostAddress.resolve(host)).isEqualTo(host);
    assertThat(HostAddress.isLoopback(host)).isTrue();
  }

  @Test
  void anAddressOfThisMachineIsTakenAsWritten() {
    String own = HostAddress.resolve("auto");
    assertThat(HostAddress.resolve(own)).isEqualTo(own);
  }

  @ParameterizedTest
  @ValueSource(strings = {"192.0.2.7", "255.0.0.255", "2001:db8::7", "::1"})
  void anAddressInDigitsNeedsNoNameService(String text) throws Exception {
    assertThat(HostAddress.literal(text)).contains(InetAddress.getByName(text));
    assertThat(HostAddress.isName(text)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "robot", "1.2.3", "256.0.0.1", "1.2.3.4.", "x::1", "1234", "[::1]"})
  void everythingElseIsNoAddress(String text) {
    assertThat(HostAddress.literal(text)).isEmpty();
    assertThat(HostAddress.isName(text)).isTrue();
  }

  @Test
  void whereItMustNotTakeLongANameIsNotVerifiedAndAnAddressIs() {
    assertThat(HostAddress.resolveWithoutLookup("no-such-host.invalid"))
        .isEqualTo("no-such-host.invalid");
    assertThat(HostAddress.resolveWithoutLookup("auto")).isEqualTo(HostAddress.resolve("auto"));
    assertThatThrownBy(() -> HostAddress.resolveWithoutLookup("203.0.113.9"))
        .isInstanceOf(ConfigurationException.class);
  }

  @Test
  void aNameThatNobodyKnowsIsRefused() {
    assertThatThrownBy(() -> HostAddress.resolve("no-such-host.invalid"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "host no-such-host.invalid is not known; name an address of this machine, or auto");
    assertThat(HostAddress.isLoopback("no-such-host.invalid")).isFalse();
  }

  @Test
  void anAddressOfAnotherMachineIsRefused() {
    assertThatThrownBy(() -> HostAddress.resolve("203.0.113.7")) // for documentation: nobody's
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "host 203.0.113.7 is not an address of this machine; name one of its addresses, or"
                + " auto");
  }

  @Test
  void aNameThatStandsForTheLoopbackOnlyHereIsRefused() throws UnknownHostException {
    InetAddress own = InetAddress.getLocalHost();
    assumeTrue(
        own.isLoopbackAddress() && !own.getHostName().equals("localhost"),
        "this machine's own name is no name of its loopback");
    assertThatThrownBy(() -> HostAddress.resolve(own.getHostName()))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "host "
                + own.getHostName()
                + " is "
                + own.getHostAddress()
                + " here, which no other machine reaches; name an address of an interface, or auto,"
                + " or localhost where only this machine is meant");
  }
}
