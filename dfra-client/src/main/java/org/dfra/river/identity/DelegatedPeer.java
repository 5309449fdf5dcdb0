package org.dfra.river.identity;

import java.lang.reflect.Method;
import java.math.BigInteger;
import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;
import javax.security.auth.Subject;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * The peer of a call that carries a delegation. It is both: the process that calls, and the member
 * on whose behalf. What it was granted ends with the right of either.
 */
final class DelegatedPeer implements ChannelPeer {

  private final ChannelPeer bearer;
  private final Delegation delegation;
  private final DelegationVerifier verifier;

  /**
   * @param bearer whose certificate the delegation names
   */
  DelegatedPeer(ChannelPeer bearer, Delegation delegation, DelegationVerifier verifier) {
    this.bearer = bearer;
    this.delegation = delegation;
    this.verifier = verifier;
  }

  @Override
  public Caller caller() {
    Caller alone = bearer.caller();
    return alone.standing() == Caller.Standing.STRANGER
        ? alone
        : alone.onBehalfOf(
            verifier
                .faultNow(delegation)
                .map(Behalf::unproved)
                .orElseGet(() -> Behalf.of(delegation.principal())));
  }

  /** The principals that the connection proves: constraints are about these. */
  @Override
  public Subject subject() {
    return bearer.subject();
  }

  @Override
  public List<BigInteger> certificateNumbers() {
    return Stream.concat(
            bearer.certificateNumbers().stream(),
            Stream.of(delegation.certificate().getSerialNumber()))
        .toList();
  }

  @Override
  public boolean isRevoked() {
    return bearer.isRevoked() || verifier.faultNow(delegation).isPresent();
  }

  @Override
  public byte @Nullable [] credentialFor(Method method) {
    return bearer.credentialFor(method);
  }

  @Override
  public void receive(byte[] credential, Collection<Object> context) {
    bearer.receive(credential, context);
  }

  @Override
  public String toString() {
    return bearer + " for " + delegation.principal();
  }
}
