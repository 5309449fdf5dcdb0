package org.dfra.river.remote.effector;

import java.io.Serializable;
import java.time.Instant;
import java.util.Objects;
import net.jini.core.lease.Lease;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.river.remote.GrantedModuleLease;

/**
 * What a server gives to a commander: its lease and its key. It does not renew itself; the client's
 * proxy does.
 *
 * @param use the lease
 * @param key what the commander's commands are accompanied by
 */
public record GrantedCommandLease(GrantedModuleLease use, CommandKey key)
    implements CommandLease, Serializable {

  public GrantedCommandLease {
    Objects.requireNonNull(use, "use");
    Objects.requireNonNull(key, "key");
  }

  /** The lease, for who renews it. */
  public Lease lease() {
    return use.lease();
  }

  @Override
  public Instant expiration() {
    return use.expiration();
  }

  @Override
  public boolean isLive() {
    return use.isLive();
  }

  @Override
  public void close() {
    use.close();
  }
}
