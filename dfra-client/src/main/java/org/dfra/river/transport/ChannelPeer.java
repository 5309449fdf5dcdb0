package org.dfra.river.transport;

import javax.security.auth.Subject;
import org.dfra.security.Caller;

/** The authenticated process at the other end of an encrypted connection. Thread-safe. */
public interface ChannelPeer {

  /** What is proved of it now: a revoked or expired certificate proves less than it did. */
  Caller caller();

  /** Its principals; empty if it has no certificate. Read-only. */
  Subject subject();

  /** Whether the connection has to be closed, since its certificate was revoked. */
  boolean isRevoked();
}
