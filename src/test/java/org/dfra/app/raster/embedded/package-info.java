/**
 * Searches by raster in one virtual machine with real lookup services, end to end. Enter at {@link
 * org.dfra.app.raster.embedded.EmbeddedMissionIT}.
 */
package org.dfra.app.raster.embedded;
