package org.dfra.autonomy;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.function.Consumer;
import net.jini.core.event.RemoteEvent;
import net.jini.core.lease.Lease;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import net.jini.lease.LeaseRenewalManager;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.river.RecruitmentAgentProxy;
import org.dfra.recruit.river.RemoteRecruitmentAgent;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.testing.EmbeddedReggie;

/** An agent that does nothing but to take down which remote events it is sent. */
final class Eavesdropper implements AutoCloseable {

  private static final Identification SELF =
      new Identification("eavesdropper", "agent", "takes down what it is sent", "DFRA", "1");

  private final RemoteRecruitmentAgent server; // JERI holds it weakly
  private final Exporter exporter;
  private final LeaseRenewalManager renewal = new LeaseRenewalManager();
  private final Lease lease;

  private Eavesdropper(String percept, EmbeddedReggie reggie, Consumer<RemoteEvent> events)
      throws RemoteException {
    this.server =
        (RemoteRecruitmentAgent)
            Proxy.newProxyInstance(
                Eavesdropper.class.getClassLoader(),
                new Class<?>[] {RemoteRecruitmentAgent.class},
                (proxy, method, arguments) -> {
                  switch (method.getName()) {
                    case "notify" -> events.accept((RemoteEvent) arguments[0]);
                    case "hashCode" -> {
                      return System.identityHashCode(proxy);
                    }
                    case "equals" -> {
                      return proxy == arguments[0];
                    }
                    default -> throw new AssertionError(method + " is not what it is for");
                  }
                  return null;
                });
    this.exporter =
        new BasicJeriExporter(
            Endpoints.tcp(EmbeddedReggie.HOST, 0), new DeadlineILFactory(), false, false);
    UUID id = UUID.randomUUID();
    RemoteRecruitmentAgent stub = (RemoteRecruitmentAgent) exporter.export(server);
    this.lease =
        reggie
            .register(
                id,
                new RecruitmentAgentProxy(stub, id, SELF),
                List.of(self(), recruitment(percept)),
                EmbeddedReggie.LEASE_MILLIS)
            .getLease();
    renewal.renewUntil(lease, Lease.FOREVER, null);
  }

  /** One that says it can observe that, found in that lookup service. */
  static Eavesdropper observing(String percept, EmbeddedReggie reggie, Consumer<RemoteEvent> events)
      throws RemoteException {
    return new Eavesdropper(percept, reggie, events);
  }

  private static ModuleAttributes self() {
    return new ModuleAttributes(
        SELF.robot(),
        SELF.name(),
        Eavesdropper.class.getName(),
        EmbeddedReggie.HOST,
        SELF.author(),
        SELF.version(),
        Readiness.READY,
        Instant.EPOCH,
        Instant.EPOCH,
        0);
  }

  private static RecruitmentAttributes recruitment(String percept) {
    return new RecruitmentAttributes(List.of(percept), 1, "none", 20, 1);
  }

  @Override
  public void close() throws Exception {
    renewal.cancel(lease);
    boolean unused = exporter.unexport(true);
  }

  @Override
  public String toString() {
    return SELF.path();
  }
}
