package org.dfra.report.plot;

import java.awt.Dimension;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.io.StringWriter;
import java.util.Objects;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.apache.batik.svggen.SVGIDGenerator;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * Paints SVG. XChart draws a line segment by segment, and points one by one, which would create
 * many elements, restart the dashes at each segment, and show every joint: this class draws
 * consecutive segments of one style as one path.
 */
final class SvgCanvas extends SVGGraphics2D {

  private static final String NAMESPACE = "http://www.w3.org/2000/svg";
  private static final int DECIMALS = 2;

  private @Nullable Run run;

  /** Consecutive segments of one style that may still grow. */
  private record Run(
      Path2D path,
      Paint paint,
      Stroke stroke,
      @Nullable Shape clip,
      @Nullable Rectangle2D clipped,
      AffineTransform transform) {

    static Run begun(SvgCanvas canvas) {
      return new Run(
          new Path2D.Double(),
          canvas.getPaint(),
          canvas.getStroke(),
          canvas.getClip(),
          clipped(canvas),
          canvas.getTransform());
    }

    private static @Nullable Rectangle2D clipped(SvgCanvas canvas) {
      Shape clip = canvas.getClip();
      return clip == null ? null : clip.getBounds2D();
    }

    boolean goesOnIn(SvgCanvas canvas) {
      return paint.equals(canvas.getPaint())
          && stroke.equals(canvas.getStroke())
          && transform.equals(canvas.getTransform())
          && Objects.equals(clipped, clipped(canvas));
    }

    void add(Line2D line) {
      if (!line.getP1().equals(path.getCurrentPoint())) {
        path.moveTo(line.getX1(), line.getY1());
      }
      path.lineTo(line.getX2(), line.getY2());
    }
  }

  private SvgCanvas(SVGGeneratorContext context, int width, int height) {
    super(context, false);
    setSVGCanvasSize(new Dimension(width, height));
  }

  /**
   * A canvas.
   *
   * @param prefix of all IDs, so that several images fit into one document
   */
  static SvgCanvas of(int width, int height, String prefix) {
    SVGGeneratorContext context = SVGGeneratorContext.createDefault(document());
    context.setPrecision(DECIMALS);
    context.setIDGenerator(
        new SVGIDGenerator() {
          @Override
          public String generateID(String kind) {
            return super.generateID(prefix + kind);
          }
        });
    return new SvgCanvas(context, width, height);
  }

  private static Document document() {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .getDOMImplementation()
          .createDocument(NAMESPACE, "svg", null);
    } catch (ParserConfigurationException e) {
      throw new IllegalStateException("this Java has no XML parser", e);
    }
  }

  @Override
  public void draw(Shape shape) {
    if (shape instanceof Line2D line) {
      Run drawn = run;
      if (drawn == null || !drawn.goesOnIn(this)) {
        finish();
        drawn = Run.begun(this);
        run = drawn;
      }
      drawn.add(line);
    } else {
      finish();
      super.draw(shape);
    }
  }

  @Override
  public void fill(Shape shape) {
    finish();
    super.fill(shape);
  }

  @Override
  public void drawString(String text, float x, float y) {
    finish();
    super.drawString(PanelText.printable(text), x, y);
  }

  /** Draws the pending segments. */
  private void finish() {
    Run ended = run;
    if (ended == null) {
      return;
    }
    run = null;
    Paint paint = getPaint();
    Stroke stroke = getStroke();
    Shape clip = getClip();
    AffineTransform transform = getTransform();
    setTransform(ended.transform());
    setClip(ended.clip());
    setPaint(ended.paint());
    setStroke(ended.stroke());
    super.draw(ended.path());
    setTransform(transform);
    setClip(clip);
    setPaint(paint);
    setStroke(stroke);
  }

  /**
   * The image as an element {@code svg}.
   *
   * @param title accessible description
   */
  String text(String title) {
    finish();
    Element svg = getRoot();
    tidy(svg);
    Dimension size = getSVGCanvasSize();
    svg.setAttribute("viewBox", "0 0 " + size.width + " " + size.height);
    svg.setAttribute("role", "img");
    Element name = svg.getOwnerDocument().createElementNS(NAMESPACE, "title");
    name.setTextContent(PanelText.printable(title));
    svg.insertBefore(name, svg.getFirstChild());
    StringWriter text = new StringWriter();
    try {
      stream(svg, text, false, false);
    } catch (SVGGraphics2DIOException e) {
      throw new IllegalStateException("a picture could not be written to memory", e);
    }
    String all = text.toString().replace("\r\n", "\n");
    return all.substring(all.indexOf("<svg")).strip() + "\n";
  }

  /** Removes the generator's comment and its IDs that are the same in every image. */
  private static void tidy(Element svg) {
    for (Node child = svg.getFirstChild(); child != null; ) {
      Node next = child.getNextSibling();
      if (child.getNodeType() == Node.COMMENT_NODE) {
        svg.removeChild(child);
      } else if (child instanceof Element element
          && "genericDefs".equals(element.getAttribute("id"))) {
        element.removeAttribute("id");
      }
      child = next;
    }
  }
}
