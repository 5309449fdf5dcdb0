package org.dfra.river.remote.effector;

import java.io.Serializable;
import java.time.Instant;
import java.util.Objects;
import net.jini.core.lease.Lease;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.river.remote.GrantedModuleLease;

/**
 * A command lease as a server grants it: its lease and its key. It does not renew itself; the
 * client's proxy does.
 *
 * @param use the lease
 * @param key the client sends it with each command
 */
public record GrantedCommandLease(GrantedModuleLease use, CommandKey key)
    implements CommandLease, Serializable {

  public GrantedCommandLease {
    Objects.requireNonNull(use, "use");
    Objects.requireNonNull(key, "key");
  }

  /** The lease, for its renewal. */
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
