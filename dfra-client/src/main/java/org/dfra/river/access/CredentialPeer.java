package org.dfra.river.access;

import java.lang.reflect.Method;
import java.util.Collection;
import org.jspecify.annotations.Nullable;

/**
 * The authenticated process at the other end of a connection, as far as calls carry more than the
 * connection proves. It is in the context of each call on an encrypted connection, at both ends.
 */
public interface CredentialPeer {

  /**
   * What a call to it carries.
   *
   * @return at most {@link CallCredential#MAX_BYTES} bytes; null for nothing
   */
  byte @Nullable [] credentialFor(Method method);

  /**
   * Verifies what a call of it carries, and replaces in the call's context what is known of the
   * caller. What proves nothing is not thrown: the guard decides, since it may not refuse a stop.
   *
   * @param context of the call
   */
  void receive(byte[] credential, Collection<Object> context);
}
