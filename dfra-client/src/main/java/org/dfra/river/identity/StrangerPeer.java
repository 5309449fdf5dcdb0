package org.dfra.river.identity;

import java.lang.reflect.Method;
import java.math.BigInteger;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import javax.security.auth.Subject;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * A peer that has not proved who it is.
 *
 * @param caller a stranger
 */
public record StrangerPeer(Caller caller) implements ChannelPeer {

  /** Nobody: no principals, no credentials. */
  public static final Subject NOBODY = new Subject(true, Set.of(), Set.of(), Set.of());

  /** The peer at an address. */
  public static StrangerPeer at(String address) {
    return new StrangerPeer(Caller.stranger(address));
  }

  @Override
  public Subject subject() {
    return NOBODY;
  }

  @Override
  public List<BigInteger> certificateNumbers() {
    return List.of();
  }

  @Override
  public boolean isRevoked() {
    return false;
  }

  @Override
  public byte @Nullable [] credentialFor(Method method) {
    return null;
  }

  /** Nobody acts for a member without being one. */
  @Override
  public void receive(byte[] credential, Collection<Object> context) {}
}
