package org.dfra.sim.world.render;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.render.MeshFace.Paint;
import org.dfra.sim.world.shape.MutableTransform;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * A robot's mesh, in its own frame: x forward, y left, z up from its base. It fills the box of its
 * description.
 */
public final class RobotMesh {

  private static final Paint BODY = new Paint(0xB4412E, 4, 0.4);
  private static final Paint DECK = new Paint(0x3A3C40, 3, 0.7);
  private static final Paint TYRE = new Paint(0x1E1E1F, 6, 0.6);
  private static final Paint FRAME = new Paint(0xE4E6E8, 3, 0.3);
  private static final Paint MOTOR = new Paint(0x26282B, 14, 0.4);
  private static final Paint ROTOR = new Paint(0x6E7277, 0, 0.2);

  final List<MeshFace> facets;
  final double radius;
  final double middle;

  private RobotMesh(List<MeshFace> facets, VehicleDescription vehicle) {
    this.facets = List.copyOf(facets);
    this.middle = vehicle.height() / 2;
    this.radius =
        Math.sqrt(
                vehicle.length() * vehicle.length()
                    + vehicle.width() * vehicle.width()
                    + vehicle.height() * vehicle.height())
            / 2;
  }

  /** The mesh of a robot. */
  public static RobotMesh of(VehicleDescription vehicle) {
    return new RobotMesh(
        vehicle.type() == VehicleType.UGV ? onWheels(vehicle) : onRotors(vehicle), vehicle);
  }

  private static List<MeshFace> onWheels(VehicleDescription vehicle) {
    double x = vehicle.length() / 2;
    double y = vehicle.width() / 2;
    double z = vehicle.height();
    double tyre = 0.2 * y;
    double wheel = Math.min(0.28 * z, 0.45 * x);
    List<MeshFace> facets = new ArrayList<>();
    facets.addAll(
        MeshBuilder.box(
            -0.95 * x, tyre * 1.2 - y, 0.22 * z, 0.95 * x, y - tyre * 1.2, 0.75 * z, BODY));
    facets.addAll(MeshBuilder.box(-0.8 * x, -0.6 * y, 0.75 * z, 0.6 * x, 0.6 * y, z, DECK));
    for (int side = -1; side <= 1; side += 2) {
      for (int end = -1; end <= 1; end += 2) {
        facets.addAll(
            MeshBuilder.wheel(end * (x - wheel), side * (y - tyre / 2), wheel, tyre, TYRE));
      }
    }
    return facets;
  }

  private static List<MeshFace> onRotors(VehicleDescription vehicle) {
    double x = vehicle.length() / 2;
    double y = vehicle.width() / 2;
    double z = vehicle.height();
    List<MeshFace> facets = new ArrayList<>();
    facets.addAll(MeshBuilder.box(-0.35 * x, -0.3 * y, 0.2 * z, 0.35 * x, 0.3 * y, 0.8 * z, FRAME));
    facets.addAll(
        MeshBuilder.box(-0.6 * x, -0.62 * y, 0.55 * z, 0.6 * x, -0.54 * y, 0.65 * z, FRAME));
    facets.addAll(
        MeshBuilder.box(-0.6 * x, 0.54 * y, 0.55 * z, 0.6 * x, 0.62 * y, 0.65 * z, FRAME));
    for (int side = -1; side <= 1; side += 2) {
      double skid = side * 0.35 * y;
      facets.addAll(
          MeshBuilder.box(-0.5 * x, skid - 0.02, 0, 0.5 * x, skid + 0.02, 0.2 * z, MOTOR));
      for (int end = -1; end <= 1; end += 2) {
        double east = end * 0.6 * x;
        double north = side * 0.58 * y;
        facets.addAll(
            MeshBuilder.prism(new Disc(east, north, 0.09 * x), 8, 0.6 * z, 0.9 * z, MOTOR));
        facets.addAll(MeshBuilder.prism(new Disc(east, north, 0.4 * x), 16, 0.9 * z, z, ROTOR));
      }
    }
    return facets;
  }

  /** Centre of a robot at this pose. */
  void middle(MutableTransform transform, double[] out) {
    out[0] = transform.east + middle * transform.xz;
    out[1] = transform.north + middle * transform.yz;
    out[2] = transform.up + middle * transform.zz;
  }
}
