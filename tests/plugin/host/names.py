"""What USD knows us by."""

RENDERER = "HdEtendueRendererPlugin"
