package org.dfra.loading;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.rmi.server.RMIClassLoader;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;

/**
 * A client that has River's jars and this class, and nothing of DFRA. Each line of its input is the
 * port of a registrar; it says where the GPS receivers there are, the codebase of their proxies,
 * and the names of DFRA's threads in its own process.
 */
final class RiverClient {

  private static final String GPS = "org.dfra.flow.sensor.GPSSensor";

  private RiverClient() {}

  public static void main(String[] args) throws Exception {
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String port; (port = in.readLine()) != null; ) {
      System.out.println("said " + ask(Integer.parseInt(port)));
    }
    System.exit(0);
  }

  private static String ask(int port) throws Exception {
    StringBuilder answers = new StringBuilder();
    ServiceRegistrar registrar = new LookupLocator("127.0.0.1", port).getRegistrar();
    for (ServiceItem item : registrar.lookup(new ServiceTemplate(null, null, null), 10).items) {
      if (!(item.service instanceof ServiceRegistrar)) {
        Class<?> gps = Class.forName(GPS, false, item.service.getClass().getClassLoader());
        answers.append(gps.getMethod("location").invoke(item.service));
        answers.append(" from ").append(RMIClassLoader.getClassAnnotation(item.service.getClass()));
      }
    }
    for (Thread each : Thread.getAllStackTraces().keySet()) {
      if (each.getName().startsWith("dfra-")) {
        answers.append(" by ").append(each.getName());
      }
    }
    return answers.toString();
  }
}
