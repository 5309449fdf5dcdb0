package org.dfra.river.lease;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.flow.effector.Effector;
import org.dfra.lease.LeaseRole;
import org.dfra.river.access.PermittedCall;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.security.AccessRequest;
import org.dfra.security.Permissions;
import org.jspecify.annotations.Nullable;

/**
 * Who has obtained a lease by a remote call, and what must be permitted to have it. What is known
 * of the caller is what was proved when it called: a certificate that expires later ends nothing.
 *
 * @param peer the caller
 * @param needs the call, and what it is useless without; empty if no guard has decided about it
 */
public record LeaseHolder(ChannelPeer peer, List<AccessRequest> needs) {

  private static final Method EXECUTE =
      Arrays.stream(Effector.class.getMethods())
          .filter(each -> each.getName().equals("execute"))
          .findFirst()
          .orElseThrow();

  /** Copies the list. */
  public LeaseHolder {
    needs = List.copyOf(needs);
  }

  /** The one that makes the remote call on this thread; empty if its connection is open. */
  public static Optional<LeaseHolder> ofCurrentCall() {
    return ChannelPeer.ofCurrentCall()
        .map(peer -> new LeaseHolder(peer, PermittedCall.current().stream().toList()));
  }

  /** The same for a role: who commands an effector must be permitted to execute commands too. */
  static Optional<LeaseHolder> ofCurrentCall(LeaseRole role) {
    Optional<LeaseHolder> holder = ofCurrentCall();
    return role == LeaseRole.COMMANDER ? holder.map(each -> each.alsoNeeding(EXECUTE)) : holder;
  }

  private LeaseHolder alsoNeeding(Method method) {
    return new LeaseHolder(
        peer, Stream.concat(needs.stream(), needs.stream().map(it -> of(it, method))).toList());
  }

  /** The same holder, as if its call had been one of another method. */
  public LeaseHolder needing(Method method) {
    return new LeaseHolder(peer, needs.stream().map(each -> of(each, method)).toList());
  }

  private static AccessRequest of(AccessRequest call, Method method) {
    return new AccessRequest(call.caller(), call.robot(), call.object(), call.type(), method);
  }

  /** Whether the team no longer believes it, or its delegation has ended. */
  public boolean isRevoked() {
    return peer.isRevoked();
  }

  /** Whether the policy in force permits what it has. */
  public boolean isStillPermitted(Permissions permissions) {
    return needs.stream().allMatch(permissions::isStillPermitted);
  }

  /** What the guard of the current identity says about earlier calls. */
  public static Permissions currentPermissions() {
    @Nullable ChannelIdentity identity = CurrentIdentity.get();
    return identity == null ? Permissions.LASTING : identity.guard().permissions();
  }

  @Override
  public String toString() {
    return needs.isEmpty() ? peer.toString() : needs.get(0).caller().toString();
  }
}
