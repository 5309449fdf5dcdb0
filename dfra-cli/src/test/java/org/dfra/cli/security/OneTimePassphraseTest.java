package org.dfra.cli.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.security.SecureRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Passphrases that people type. */
class OneTimePassphraseTest {

  private static final String PASSPHRASE = "k7x2m-9qhbt-ws4fe-c3zdn-pv8ra";

  @Test
  void hasFiveGroupsAndIsAnotherEachTime() {
    SecureRandom random = new SecureRandom();
    String first = OneTimePassphrase.create(random);
    assertThat(first).matches("[a-km-np-z2-9]{5}(-[a-km-np-z2-9]{5}){4}");
    assertThat(OneTimePassphrase.create(random)).isNotEqualTo(first);
    assertThat(OneTimePassphrase.normalized(first)).isEqualTo(first);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        PASSPHRASE,
        "K7X2M-9QHBT-WS4FE-C3ZDN-PV8RA",
        "k7x2m9qhbtws4fec3zdnpv8ra",
        " k7x2m 9qhbt ws4fe c3zdn pv8ra\n"
      })
  void isUnderstoodHoweverItIsTyped(String typed) {
    assertThat(OneTimePassphrase.normalized(typed)).isEqualTo(PASSPHRASE);
  }

  @Test
  void anotherTextStaysAsItIs() {
    assertThat(OneTimePassphrase.normalized("Not-One of them")).isEqualTo("Not-One of them");
  }
}
