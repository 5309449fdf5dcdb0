package org.dfra.lease;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.UUID;
import org.junit.jupiter.api.Test;

class LeaseHandleTest {

  @Test
  void isTheSameForBothAndNotTheSecretItself() {
    UUID secret = UUID.randomUUID();
    LeaseHandle handle = LeaseHandle.of(secret);
    assertThat(LeaseHandle.of(UUID.fromString(secret.toString()))).isEqualTo(handle);
    assertThat(handle.value()).isNotEqualTo(secret);
    assertThat(LeaseHandle.of(handle.value())).as("a digest of it is another").isNotEqualTo(handle);
    assertThat(LeaseHandle.of(UUID.randomUUID())).isNotEqualTo(handle);
  }

  /** Of the ID 00000000-0000-0001-0000-000000000002, by another implementation of SHA-256. */
  private static final String KNOWN = "a6a1ab07-dc6c-5958-9561-93fb932d23eb";

  /** A robot and an operator of different versions must agree, so the digest never changes. */
  @Test
  void isTheFirstHalfOfADigest() {
    assertThat(LeaseHandle.of(new UUID(1, 2))).hasToString(KNOWN);
  }
}
