package org.dfra.river.server;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Optional;
import java.util.Properties;
import java.util.UUID;
import org.dfra.core.state.StateStore;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The permanent identity of a module of its robot. It is stored beside the module's own state, so
 * that it survives a move to another group and {@code ./dfra down}.
 *
 * @param id its service ID in every lookup service
 * @param created when it was first registered with its robot, UTC
 */
public record ModuleIdentity(UUID id, Instant created) {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleIdentity.class);
  private static final String DOCUMENT = "identity";
  private static final String ID = "id";
  private static final String CREATED = "created";

  /** Creates one for a module that was never registered. */
  public static ModuleIdentity fresh() {
    return new ModuleIdentity(UUID.randomUUID(), Instant.now());
  }

  /** The stored identity in a module's folder; empty if none can be read. */
  public static Optional<ModuleIdentity> load(Path folder) {
    try {
      return read(folder);
    } catch (IOException e) {
      LOG.warn("The identity in {} cannot be read ({}); the module gets a new one.", folder, e);
      return Optional.empty();
    }
  }

  /**
   * As {@link #load}, for callers that create no new one.
   *
   * @throws IOException if there is one that cannot be read
   */
  static Optional<ModuleIdentity> read(Path folder) throws IOException {
    Optional<byte[]> document = StateStore.inFolder(folder).read(DOCUMENT);
    if (document.isEmpty()) {
      return Optional.empty();
    }
    try {
      Properties properties = new Properties();
      properties.load(new StringReader(new String(document.get(), StandardCharsets.UTF_8)));
      return Optional.of(
          new ModuleIdentity(
              UUID.fromString(properties.getProperty(ID, "")),
              Instant.parse(properties.getProperty(CREATED, ""))));
    } catch (IllegalArgumentException | DateTimeException e) {
      throw new IOException(e.toString(), e);
    }
  }

  /**
   * Stores it in a module's folder, unless the same is there already.
   *
   * @throws IOException if it cannot be written
   */
  public void store(Path folder) throws IOException {
    if (!load(folder).equals(Optional.of(this))) {
      String text = ID + "=" + id + "\n" + CREATED + "=" + created + "\n";
      StateStore.inFolder(folder).write(DOCUMENT, text.getBytes(StandardCharsets.UTF_8));
    }
  }
}
