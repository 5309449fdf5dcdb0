package org.dfra.drivers.link;

import java.io.IOException;
import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * What a driver does with its link. All methods are called by the {@link LinkKeeper}'s thread and
 * must not block.
 */
public interface LinkHandler {

  /**
   * The link has been opened: sends what the device must be told first.
   *
   * @throws IOException if the link is lost already
   */
  void opened(SerialLink link) throws IOException;

  /**
   * Takes bytes that came.
   *
   * @param bytes holds them from index 0; valid only during the call
   * @param length how many
   * @return whether they showed that the right device is at the other end and alive
   */
  boolean received(byte[] bytes, int length);

  /**
   * Called after every read, in vain or not: sends what is due by now and judges the device.
   *
   * @return why the link must be opened anew, as a clause ({@code no frame for 5 s}); null while
   *     all is well
   * @throws IOException if the link is lost
   */
  @Nullable String periodic(SerialLink link) throws IOException;

  /**
   * The longest wait for bytes before {@link #periodic} is called all the same: less than usual
   * where something has to be sent in time. A link may round it up to its own resolution.
   */
  default Duration pollInterval() {
    return LinkKeeper.READ_TIMEOUT;
  }

  /**
   * There is no link now; it will be opened again after a while.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
