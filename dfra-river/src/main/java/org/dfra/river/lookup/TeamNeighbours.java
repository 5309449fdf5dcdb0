package org.dfra.river.lookup;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import net.jini.core.lookup.ServiceItem;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.security.SecureProcess;
import org.jspecify.annotations.Nullable;

/**
 * A process of each robot that a lookup service lists, to exchange news of the team with: what one
 * has is shared by all processes of its robot. Confined to one thread.
 */
final class TeamNeighbours {

  private final Map<String, PeerAddress> processes = new HashMap<>(); // by the robot's name

  /** Forgets the former ones. */
  void replaceAll(Collection<ServiceItem> items) {
    processes.clear();
    items.forEach(this::add);
  }

  /** Adds what was registered or has changed. */
  void add(ServiceItem item) {
    if (item.service instanceof ModuleProxy<?> module) {
      @Nullable PeerAddress address = PeerAddress.of(module.server());
      if (address != null) {
        processes.put(module.identification().robot(), address);
      }
    }
  }

  /** Exchanges with those where something is due, if this process is secure. */
  void exchangeNews() {
    SecureProcess.news().ifPresent(news -> processes.forEach(news::with));
  }
}
