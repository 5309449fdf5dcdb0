package org.dfra.attack.answer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.id.UuidFactory;
import net.jini.io.MarshalInputStream;
import net.jini.io.MarshalOutputStream;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.entry.Entries;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is large and honest passes the limits that stop attacks. */
@Timeout(60)
class LargeAnswersTest {

  private static final ClassLoader LOADER = LargeAnswersTest.class.getClassLoader();

  /** In one answer of a lookup service. */
  private static final int MODULES = 3_000;

  /** As many are made. They are written again and again, into one stream, which counts them all. */
  private static final int MADE = 300;

  /** Of one module at the least: its proxy and its entries. */
  private static final int MODULE_BYTES = 1_000;

  @Test
  void aLookupServiceAnswersWithThousandsOfModules() throws Exception {
    List<Object> items = new ArrayList<>();
    for (int i = 0; i < MADE; i++) {
      items.add(item(i));
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      for (int i = 0; i < MODULES / MADE; i++) {
        out.writeObject(items);
        out.reset(); // what follows refers to nothing before
      }
    }
    assertThat(bytes.size()).as("bytes of the answer").isGreaterThan(MODULES * MODULE_BYTES);
    Method lookup = ServiceRegistrar.class.getMethod("lookup", ServiceTemplate.class, int.class);
    int read = 0;
    try (ObjectInputStream in = result(bytes.toByteArray(), lookup)) {
      for (int i = 0; i < MODULES / MADE; i++) {
        read += ((List<?>) in.readObject()).size();
      }
    }
    assertThat(read).isEqualTo(MODULES);
  }

  @Test
  void anImageIsAResultAndComesWithAnEvent() throws Exception {
    CameraImage frame = frame();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      out.writeObject(frame);
    }
    Method image = CameraSensor.class.getMethod("image");
    try (ObjectInputStream in = result(bytes.toByteArray(), image)) {
      assertThat(in.readObject()).isEqualTo(frame);
    }
    try (OpenBox box = new OpenBox()) {
      Delivery event = new Delivery("atrv1/camera", 1, 1, 0, Instant.EPOCH, new NewReading(frame));
      assertThat(box.proxy().put(event)).isEqualTo(1);
    }
  }

  /** A module in reggie's form, as reggie's proxy sends and receives it. */
  private static Object item(int number) throws Exception {
    String robot = "robot" + number;
    Object server =
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient("192.0.2.1", 5_000 + number),
                UuidFactory.create(1, number),
                false),
            Duration.ofSeconds(2),
            LOADER,
            RemoteGPSSensor.class);
    GPSProxy proxy =
        new GPSProxy(
            (RemoteGPSSensor) server,
            new UUID(1, number),
            new Identification(robot, "gps_front", "M12+", "DFRA", "1.0"));
    Constructor<?> form =
        Class.forName("com.sun.jini.reggie.Item").getDeclaredConstructor(ServiceItem.class);
    form.setAccessible(true);
    return form.newInstance(
        new ServiceItem(
            new ServiceID(1, number),
            proxy,
            Entries.toEntries(
                List.of(
                    new ModuleAttributes(
                        robot,
                        "gps_front",
                        "org.example.Driver",
                        "192.0.2.1",
                        "DFRA",
                        "1.0",
                        Readiness.READY,
                        Instant.EPOCH,
                        Instant.EPOCH,
                        number),
                    new ChainAttributes(List.of(), List.of(robot + "/position")),
                    new SensorAttributes("GpsFix", List.of("m"), 0.1, 5, 2.5, List.of("sky")),
                    new GpsReceiverAttributes("M12+", robot, "P04", "2", 12, List.of("2D", "3D")),
                    new PoseAttributes(robot + "/gps", robot + "/base_link", 0, 0, 1, 0, 0, number),
                    new LocationAttributes(52.9, 6.8, number, Instant.EPOCH)))));
  }

  /** 640 × 480 pixels of three colours that no encoding has made smaller. */
  private static CameraImage frame() {
    byte[] data = new byte[640 * 480 * 3];
    return new CameraImage(
        Instant.EPOCH, "atrv1/camera", CameraImage.Band.VISIBLE, 640, 480, 500, "image/png", data);
  }

  /** The stream of a call's result, guarded as DFRA's proxies guard it. */
  private static ObjectInputStream result(byte[] bytes, Method method) throws IOException {
    OutboundRequest request =
        (OutboundRequest)
            Proxy.newProxyInstance(
                LOADER,
                new Class<?>[] {OutboundRequest.class},
                (self, asked, arguments) -> {
                  assertThat(asked.getName()).isEqualTo("getResponseInputStream");
                  return new ByteArrayInputStream(bytes);
                });
    return SerialFilters.openResult(
        request,
        method,
        bounded ->
            new MarshalInputStream(
                bounded.getResponseInputStream(), LOADER, false, null, List.of()));
  }
}
