package org.dfra.river.identity;

import java.lang.reflect.Method;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;

/** What the calls of an identity carry beyond what their connections prove. Thread-safe. */
@FunctionalInterface
public interface OutgoingCredentials {

  /**
   * What a call carries. Asked for each call to another member; must not wait.
   *
   * @param server who is called
   * @return null for nothing
   */
  byte @Nullable [] of(Method method, Member server);
}
