package org.dfra.drivers.laser.lms;

import java.io.IOException;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/** The request under way, of which there is one at most. Confined to the reader thread. */
final class PendingRequest {

  private static final int TRIES = 3;

  private @Nullable LmsRequest request;
  private int tries;
  private long sentNanos;
  private boolean responsive; // something intact, since it was sent
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

  /** What is under way; null where nothing is. */
  @Nullable Kind kind() {
    LmsRequest now = request;
    return now == null ? null : now.kind();
  }

  /** It is answered, or given up. */
  void end() {
    request = null;
  }

  /** The laser has said something intact. */
  void markResponsive() {
    responsive = true;
  }

  /** The laser could not read it. */
  void markUnreadable() {
    responsive = true;
    unread = true;
  }

  /** Whether no answer will come any more. */
  boolean isOverdue(long now) {
    LmsRequest sent = request;
    return sent != null && (unread || now - sentNanos >= sent.kind().timeout().toNanos());
  }

  /**
   * Sends it again, if that is sensible: at a speed at which the laser may not be only if it was
   * heard at it, and what wears the laser out only if it did not read it.
   *
   * @param isFound whether the laser is known to be at this speed
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
