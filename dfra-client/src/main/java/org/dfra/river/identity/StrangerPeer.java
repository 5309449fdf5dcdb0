package org.dfra.river.identity;

import java.math.BigInteger;
import java.util.Optional;
import java.util.Set;
import javax.security.auth.Subject;
import org.dfra.security.Caller;

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
  public Optional<BigInteger> certificateNumber() {
    return Optional.empty();
  }

  @Override
  public boolean isRevoked() {
    return false;
  }
}
