package org.dfra.river.phoenix;

import java.util.UUID;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;

/**
 * The identities under which phoenix exports its services. They never change, so that a proxy of a
 * former phoenix reaches the next one on the same host and port.
 */
public final class Identities {

  /** The activator, which anybody may call. */
  public static final Uuid ACTIVATOR = uuid("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a11");

  /** The activation system, for callers on the same machine. */
  public static final Uuid SYSTEM = uuid("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a12");

  /** The monitor, for groups on the same machine. */
  public static final Uuid MONITOR = uuid("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a13");

  private Identities() {}

  private static Uuid uuid(String text) {
    UUID uuid = UUID.fromString(text);
    return UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
  }
}
