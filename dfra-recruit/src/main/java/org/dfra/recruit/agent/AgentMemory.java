package org.dfra.recruit.agent;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.Optional;
import org.dfra.core.state.StateStore;

/**
 * Keeps what of an agent outlives its process.
 *
 * <p>It is written, and brought to the disk, within the turn in which it changed, before anything
 * that follows from it is sent: whoever gets a letter can rely on that its sender still knows what
 * it said. So a slow disk holds up the agent's next turn, and with it others' letters to it, by as
 * long as a write takes, milliseconds; a state changes some ten times for a call. Written outside
 * of the turn, the letters of several turns would have to wait for their writes in order, and what
 * waits would be lost where the module ends. {@link Recruiter#status} does not wait.
 */
final class AgentMemory {

  private static final String DOCUMENT = "recruitment";

  /** What a snapshot is made of, and no more: the file may have been tampered with. */
  private static final ObjectInputFilter SNAPSHOTS =
      ObjectInputFilter.Config.createFilter(
          "org.dfra.agent.*;org.dfra.geometry.*;org.dfra.recruit.**;java.lang.*;java.time.*;"
              + "java.util.*;maxdepth=20;maxarray=100000;!*");

  private final StateStore state;

  AgentMemory(StateStore state) {
    this.state = state;
  }

  /**
   * @throws IOException if it cannot be written; then what was kept before is kept
   */
  void keep(AgentSnapshot snapshot) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(snapshot);
    }
    state.write(DOCUMENT, bytes.toByteArray());
  }

  /**
   * What was kept.
   *
   * @throws IOException if it cannot be read, or is something else
   */
  Optional<AgentSnapshot> recall() throws IOException {
    Optional<byte[]> kept = state.read(DOCUMENT);
    if (kept.isEmpty()) {
      return Optional.empty();
    }
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(kept.get()))) {
      in.setObjectInputFilter(SNAPSHOTS);
      if (in.readObject() instanceof AgentSnapshot snapshot) {
        return Optional.of(snapshot);
      }
      throw new InvalidObjectException("what was kept of the agent is something else");
    } catch (ClassNotFoundException | RuntimeException e) {
      throw new IOException("what was kept of the agent cannot be read: " + e, e);
    }
  }
}
