package org.dfra.app.raster.embedded;

import java.rmi.RemoteException;
import java.util.Map;
import java.util.TreeMap;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.module.Module;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.entry.ModuleEntry;

/** The modules of a robot that a registrar lists. */
final class RegistrarContents {

  private RegistrarContents() {}

  /** Proxies of the robot's modules in its own registrar, by their service IDs. */
  static Map<String, Module> query(EmbeddedRobot robot) throws RemoteException {
    Map<String, Module> modules = new TreeMap<>();
    ModuleEntry own = new ModuleEntry();
    own.robot = robot.name();
    ServiceTemplate all = new ServiceTemplate(null, null, new Entry[] {own});
    for (ServiceItem each : robot.registrar().registrar().lookup(all, Integer.MAX_VALUE).items) {
      if (each.service instanceof Module module) { // null if its class cannot be loaded
        modules.put(each.serviceID.toString(), module);
      }
    }
    return modules;
  }
}
