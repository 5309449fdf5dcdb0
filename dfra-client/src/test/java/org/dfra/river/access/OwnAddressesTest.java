package org.dfra.river.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OwnAddressesTest {

  private static boolean isOwn(String host, String address) throws Exception {
    return OwnAddresses.exportedAt(host).contains(InetAddress.getByName(address));
  }

  @ParameterizedTest
  @CsvSource({
    "127.0.0.1, 127.0.0.1, true",
    "127.0.0.1, 127.0.0.66, false",
    "127.1.2.10, 127.1.2.10, true",
    "127.1.2.10, 127.0.0.1, true", // where programs call from that bind no address
    "127.1.2.10, 127.1.2.66, false",
    "127.1.2.10, 127.1.2.1, false",
    "localhost, 127.0.0.1, true",
    "::1, ::1, true",
    "127.0.0.1, 192.0.2.1, false", // reserved for documents: nobody's
  })
  void onTheLoopbackOnlyTheOneThatIsExportedAndTheDefault(
      String host, String address, boolean isOwn) throws Exception {
    assertThat(isOwn(host, address)).isEqualTo(isOwn);
  }

  @Test
  void elsewhereTheWholeLoopbackAndEveryInterface() throws Exception {
    assertThat(isOwn("192.0.2.1", "127.0.0.66")).isTrue();
    assertThat(isOwn("192.0.2.1", "203.0.113.77")).as("another computer").isFalse();
    List<InetAddress> all =
        NetworkInterface.networkInterfaces().flatMap(NetworkInterface::inetAddresses).toList();
    assertThat(all).isNotEmpty().allMatch(OwnAddresses.exportedAt("192.0.2.1")::contains);
    assertThat(all).allMatch(OwnAddresses.exportedAt(null)::contains);
  }

  @Test
  void theLinkLocalAddressOfOneInterfaceIsAnybodysOnAnothersLink() throws Exception {
    Optional<Inet6Address> found =
        NetworkInterface.networkInterfaces()
            .flatMap(NetworkInterface::inetAddresses)
            .filter(Inet6Address.class::isInstance)
            .map(Inet6Address.class::cast)
            .filter(Inet6Address::isLinkLocalAddress)
            .findFirst();
    assumeTrue(found.isPresent(), "no interface here has a link-local address");
    Inet6Address own = found.orElseThrow();
    int other = NetworkInterface.getByInetAddress(InetAddress.getLoopbackAddress()).getIndex();
    InetAddress elsewhere = Inet6Address.getByAddress(null, own.getAddress(), other);
    OwnAddresses addresses = OwnAddresses.ofThisComputer();
    assertThat(addresses.contains(own)).isTrue();
    assertThat(addresses.contains(elsewhere)).isFalse();
  }
}
