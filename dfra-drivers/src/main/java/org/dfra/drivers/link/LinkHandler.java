package org.dfra.drivers.link;

import java.io.IOException;
import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * A driver's handler for its link. The {@link LinkKeeper}'s thread calls all methods; they must not
 * block.
 */
public interface LinkHandler {

  /**
   * The link has been opened: sends the initial commands.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /**
   * Processes received bytes.
   *
   * @param bytes holds them from index 0; valid only during the call
   * @param length how many
   * @return whether they show that the expected device is connected and alive
   */
  boolean received(byte[] bytes, int length);

  /**
   * Called after every read, with or without bytes: sends what is due and checks that the device is
   * alive.
   *
   * @return why the link must be reopened, as a clause ({@code no frame for 5 s}); null without a
   *     fault
   * @throws IOException if the link is lost
   */
  @Nullable String periodic(SerialLink link) throws IOException;

  /**
   * Maximum wait for bytes between calls of {@link #periodic}; shorter where messages must be sent
   * on time. A link may round it up to its own resolution.
   */
  default Duration pollInterval() {
    return LinkKeeper.READ_TIMEOUT;
  }

  /**
   * The link is lost; it will be reopened after the back-off.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
