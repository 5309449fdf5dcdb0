package org.dfra.river.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AddressRangeTest {

  @ParameterizedTest
  @CsvSource({
    "10.0.0.7, 10.0.0.7, true",
    "10.0.0.7, 10.0.0.8, false",
    "10.0.0.0/24, 10.0.0.255, true",
    "10.0.0.0/24, 10.0.1.0, false",
    "10.0.0.0/23, 10.0.1.0, true",
    "10.0.0.9/30, 10.0.0.11, true",
    "10.0.0.9/30, 10.0.0.12, false",
    "128.0.0.0/1, 255.1.2.3, true",
    "128.0.0.0/1, 127.1.2.3, false",
    "0.0.0.0/0, 203.0.113.1, true",
    "0.0.0.0/0, fd00::1, false",
    "fd00::/8, fdff::1, true",
    "fd00::/8, fe80::1, false",
    "fd00::1, fd00:0:0:0:0:0:0:1, true",
  })
  void holdsTheAddressesThatBeginWithTheSameBits(String range, String address, boolean isIn)
      throws UnknownHostException {
    AddressRange read = AddressRange.of(range);
    assertThat(read.contains(InetAddress.getByName(address))).isEqualTo(isIn);
    assertThat(AddressRange.of(read.toString())).isEqualTo(read);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "base", "10.0.0", "10.0.0.256", "10.0.0.0/", "10.0.0.0/x", "::g", "base/8"})
  void looksNothingUp(String text) {
    assertThatThrownBy(() -> AddressRange.of(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "\""
                + text
                + "\" is neither an address nor a range; write 10.0.0.7, 10.0.0.0/24 or fd00::/8");
  }

  @Test
  void refusesAPrefixThatIsLongerThanTheAddress() {
    assertThatThrownBy(() -> AddressRange.of("10.0.0.0/33"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("the prefix of 10.0.0.0/33 is outside 0 to 32; ");
  }
}
