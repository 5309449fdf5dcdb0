package org.dfra.lease;

import java.io.Serializable;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Objects;
import java.util.UUID;

/**
 * The public name of a lease: listings show it, and an administrator uses it to revoke the lease.
 * It is not secret. Renewing and cancelling need the lease's ID, which only its holder and its
 * grantor know; the handle is a one-way digest of it, so both can compute the handle, but the ID
 * cannot be computed from it.
 *
 * @param value the first 128 bits of the digest
 */
public record LeaseHandle(UUID value) implements Serializable, Comparable<LeaseHandle> {

  private static final byte[] PURPOSE = "dfra lease handle".getBytes(StandardCharsets.US_ASCII);

  public LeaseHandle {
    Objects.requireNonNull(value, "value");
  }

  /**
   * The handle of a lease.
   *
   * @param secret the lease's ID; it must be random, since a digest does not hide a guessable value
   */
  public static LeaseHandle of(UUID secret) {
    MessageDigest digest = sha256();
    digest.update(PURPOSE);
    digest.update(
        ByteBuffer.allocate(2 * Long.BYTES)
            .putLong(secret.getMostSignificantBits())
            .putLong(secret.getLeastSignificantBits())
            .flip());
    ByteBuffer first = ByteBuffer.wrap(digest.digest());
    return new LeaseHandle(new UUID(first.getLong(), first.getLong()));
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has SHA-256", e);
    }
  }

  @Override
  public int compareTo(LeaseHandle other) {
    return value.compareTo(other.value);
  }

  /** The handle as listings show it. */
  @Override
  public String toString() {
    return value.toString();
  }
}
