package org.dfra.drivers.laser.lms;

import java.io.IOException;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/** The pending request; at most one at a time. Confined to the reader thread. */
final class PendingRequest {

  private static final int TRIES = 3;

  private @Nullable LmsRequest request;
  private int tries;
  private long sentNanos;
  private boolean responsive; // an intact message was received since it was sent
  private boolean unread; // the laser could not read it

  /** Sends a request. */
  void start(SerialLink link, LmsRequest next, long now) throws IOException {
    request = next;
    tries = 0;
    send(link, next, now);
  }

  private void send(SerialLink link, LmsRequest next, long now) throws IOException {
    tries++;
    sentNanos = now;
    responsive = false;
    unread = false;
    link.write(next.telegram());
  }

  /** Kind of the pending request; null if there is none. */
  @Nullable Kind kind() {
    LmsRequest now = request;
    return now == null ? null : now.kind();
  }

  /** Ends the request: it is answered, or given up. */
  void end() {
    request = null;
  }

  /** The laser has sent an intact message. */
  void markResponsive() {
    responsive = true;
  }

  /** The laser could not read the request. */
  void markUnreadable() {
    responsive = true;
    unread = true;
  }

  /** Whether the timeout for the answer has expired. */
  boolean isOverdue(long now) {
    LmsRequest sent = request;
    return sent != null && (unread || now - sentNanos >= sent.kind().timeout().toNanos());
  }

  /**
   * Resends the request, if sensible: at an unconfirmed baud rate only if the laser has sent data
   * at it, and a flash write only if the laser could not read it.
   *
   * @param isFound whether the laser is known to use this baud rate
   * @return whether it was sent again
   */
  boolean repeat(SerialLink link, boolean isFound, long now) throws IOException {
    LmsRequest sent = request;
    if (sent == null
        || tries >= TRIES
        || (!isFound && !responsive)
        || (sent.kind() == Kind.CONFIGURE && !unread)) {
      return false;
    }
    send(link, sent, now);
    return true;
  }
}
