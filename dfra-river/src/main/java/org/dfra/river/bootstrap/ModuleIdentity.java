package org.dfra.river.bootstrap;

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
 * What a module is known by for as long as its robot has it: kept beside what the module itself
 * remembers, so that it outlives a move to another group and {@code ./dfra down}.
 *
 * @param id its service ID in every lookup service
 * @param created when it was first registered with its robot, UTC
 */
record ModuleIdentity(UUID id, Instant created) {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleIdentity.class);
  private static final String DOCUMENT = "identity";
  private static final String ID = "id";
  private static final String CREATED = "created";

  /** One for a module that was never registered. */
  static ModuleIdentity fresh() {
    return new ModuleIdentity(UUID.randomUUID(), Instant.now());
  }

  /** The one that is kept in a module's folder; empty where there is none that can be read. */
  static Optional<ModuleIdentity> kept(Path folder) {
    try {
      Optional<byte[]> document = StateStore.in(folder).read(DOCUMENT);
      if (document.isEmpty()) {
        return Optional.empty();
      }
      Properties properties = new Properties();
      properties.load(new StringReader(new String(document.get(), StandardCharsets.UTF_8)));
      return Optional.of(
          new ModuleIdentity(
              UUID.fromString(properties.getProperty(ID, "")),
              Instant.parse(properties.getProperty(CREATED, ""))));
    } catch (IOException | IllegalArgumentException | DateTimeException e) {
      LOG.warn("The identity in {} cannot be read ({}); the module gets a new one.", folder, e);
      return Optional.empty();
    }
  }

  /** Keeps it in a module's folder; nothing is written where it is there already. */
  void keep(Path folder) throws IOException {
    if (!kept(folder).equals(Optional.of(this))) {
      String text = ID + "=" + id + "\n" + CREATED + "=" + created + "\n";
      StateStore.in(folder).write(DOCUMENT, text.getBytes(StandardCharsets.UTF_8));
    }
  }
}
