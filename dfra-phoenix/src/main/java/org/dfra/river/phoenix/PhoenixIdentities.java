package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.file.Path;
import java.util.UUID;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;

/**
 * The identities under which phoenix exports its services. They survive restarts of phoenix. So a
 * proxy of a former phoenix reaches the next one on the same host and port.
 *
 * <p>The activator's identity is well known. Those of the activation system and the monitor are
 * secrets of phoenix's user. Only a process that may read the {@linkplain #FILE file} beside the
 * journal can call them, and the groups, to which phoenix sends them.
 */
public final class PhoenixIdentities {

  /** The activator, which any client may call. */
  public static final Uuid ACTIVATOR = uuid("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a11");

  /**
   * Name of the file with the secret identities, in the folder of the journal; its mode is 0600.
   */
  public static final String FILE = "identity";

  private PhoenixIdentities() {}

  /**
   * The identity of the activation system, for {@code systemExporter} in a configuration.
   *
   * @param persistenceDirectory folder of the journal; created if missing
   * @throws IOException if the folder is not private, or the file cannot be created or read
   */
  public static Uuid system(String persistenceDirectory) throws IOException {
    return SecretIdentities.in(Path.of(persistenceDirectory)).system();
  }

  /** The identity of the monitor, as {@link #system}, for {@code monitorExporter}. */
  public static Uuid monitor(String persistenceDirectory) throws IOException {
    return SecretIdentities.in(Path.of(persistenceDirectory)).monitor();
  }

  /**
   * Parses an identity.
   *
   * @throws IllegalArgumentException if the text is none
   */
  static Uuid uuid(String text) {
    return uuid(UUID.fromString(text));
  }

  static Uuid uuid(UUID uuid) {
    return UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
  }
}
